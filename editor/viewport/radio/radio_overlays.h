#pragma once
// Radio overlays of the views: antenna lobes, links, and the coverage of one transmitter. Computed only while displayed, and
// without access to the running world.

#include <QObject>

#include "editor/viewport/radio/radio_worker.h"

namespace trundle {

class Selection;
class ViewportScene;
class ViewSettings;

class RadioOverlays final : public QObject {
    Q_OBJECT
public:
    /// All arguments must outlive this object.
    RadioOverlays(const ViewportScene& world, const Selection& selection, const ViewSettings& settings,
                  QObject* parent = nullptr);
    ~RadioOverlays() override;

    /// The displayed radio nodes; empty while no radio overlay is enabled.
    [[nodiscard]] const std::vector<RadioNode>& nodes() const { return *m_nodes; }
    /// Selected radios, by node; empty: all.
    [[nodiscard]] const std::vector<bool>& selected() const { return m_selected; }
    /// Lobes and coverage, for images of the current experiment.
    [[nodiscard]] const SceneOverlay& inScene() const { return m_inScene; }
    [[nodiscard]] double lobeUnit() const { return m_lobeUnit; } ///< m, lobe radius at 0 dBi; 0: there are no lobes
    /// Null if there are no links, or none are computed yet.
    [[nodiscard]] const RadioLinks* links() const { return m_links ? &*m_links : nullptr; }
    /// Coverage of the selected radio, of the one selected last, or of the first. Null if there is none, or it is not computed
    /// yet.
    [[nodiscard]] const CoverageMap* coverage() const { return m_coverage ? &*m_coverage : nullptr; }

    [[nodiscard]] bool isComputing() const { return m_linksAwaited || m_coverageAwaited; }
    /// Numbers of requests sent to the worker, and of coverages that it gave up. For tests.
    [[nodiscard]] int requests() const { return int(m_number); }
    [[nodiscard]] int coveragesGivenUp() const { return m_givenUp; }

Q_SIGNALS:
    void sceneChanged(); ///< inScene() changed
    void linksChanged(); ///< links() changed, or computing has ended

private:
    void updateScene();
    void choose();
    void follow();
    void makeLobes();
    void requestLinks();
    void requestCoverage();
    void takeLinks(std::uint64_t number, RadioLinks links);
    void takeCoverage(std::uint64_t number, CoverageMap map, bool last);
    void takeGivenUp(std::uint64_t number);
    void dropLinks();
    void dropCoverage();
    [[nodiscard]] std::optional<std::size_t> nodeAt(const std::string& path) const;
    [[nodiscard]] RadioPoses places() const;
    /// The poses that the links depend on, or with a node those that its coverage depends on.
    [[nodiscard]] std::vector<Pose> posesBehind(std::optional<std::size_t> transmitter) const;
    [[nodiscard]] double largestRobot() const;
    [[nodiscard]] RadioWorker& worker();

    const ViewportScene& m_world;
    const Selection& m_selection;
    const ViewSettings& m_settings;
    unsigned m_shown = 0; // enabled radio overlays, as bits of Overlay
    std::shared_ptr<const std::vector<RadioNode>> m_nodes = std::make_shared<std::vector<RadioNode>>();
    std::vector<bool> m_selected;
    std::string m_transmitter; // path
    SceneOverlay m_inScene;
    double m_lobeUnit = 0;
    std::optional<RadioLinks> m_links;
    std::optional<CoverageMap> m_coverage;
    std::optional<CoverageRequest> m_wanted;        // the last request
    std::vector<Pose> m_linkPoses, m_coveragePoses; // poses of the last requests; empty: none
    std::uint64_t m_number = 0;                     // number of the last request
    std::uint64_t m_oldest = 0;                     // results with a lower number are dropped
    std::uint64_t m_linkNumber = 0, m_coverageNumber = 0;
    bool m_linksAwaited = false, m_coverageAwaited = false;
    int m_givenUp = 0;
    std::unique_ptr<RadioWorker> m_worker; // created on first use; its thread ends before the other members are destroyed
};

} // namespace trundle
