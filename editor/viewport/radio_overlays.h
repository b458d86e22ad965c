#pragma once
// What of the radios lies over the views: antenna lobes, links, and the coverage of one transmitter. Nothing is reckoned of what nobody
// wants to see, and nothing of it touches a run.

#include <QObject>

#include "editor/viewport/radio_reckoner.h"

namespace trundle {

class Selection;
class ShownWorld;
class ViewSettings;

class RadioOverlays final : public QObject {
    Q_OBJECT
public:
    /// All outlive this.
    RadioOverlays(const ShownWorld& world, const Selection& selection, const ViewSettings& settings, QObject* parent = nullptr);
    ~RadioOverlays() override;

    /// Of what the views show; none while nobody wants to see radios.
    [[nodiscard]] const std::vector<RadioNode>& nodes() const { return *m_nodes; }
    /// Those that the selection means, by node; empty: all.
    [[nodiscard]] const std::vector<bool>& selected() const { return m_selected; }
    /// Lobes and coverage, for pictures of the experiment that is shown now.
    [[nodiscard]] const SceneOverlay& inScene() const { return m_inScene; }
    [[nodiscard]] double lobeUnit() const { return m_lobeUnit; } ///< m, where the gain is 0 dBi; 0: there are no lobes
    /// Null: there are none, or not yet.
    [[nodiscard]] const RadioLinks* links() const { return m_links ? &*m_links : nullptr; }
    /// Of the selected radio, the one selected last, or the first. Null: there is none, or not yet.
    [[nodiscard]] const CoverageMap* coverage() const { return m_coverage ? &*m_coverage : nullptr; }

    [[nodiscard]] bool isReckoning() const { return m_linksAwaited || m_coverageAwaited; }
    [[nodiscard]] int wishes() const { return int(m_number); } ///< sent to the thread so far
    [[nodiscard]] int coveragesGivenUp() const { return m_givenUp; }

Q_SIGNALS:
    void sceneChanged(); ///< inScene() is another one
    void linksChanged(); ///< links() are others, or reckoning has ended

private:
    void look();
    void choose();
    void follow();
    void makeLobes();
    void wantLinks();
    void wantCoverage();
    void takeLinks(std::uint64_t number, RadioLinks links);
    void takeCoverage(std::uint64_t number, CoverageMap map, bool last);
    void takeGivenUp(std::uint64_t number);
    void dropLinks();
    void dropCoverage();
    [[nodiscard]] std::optional<std::size_t> nodeAt(const std::string& path) const;
    [[nodiscard]] RadioPlaces places() const;
    /// What the links depend on, or with a node the coverage of that one.
    [[nodiscard]] std::vector<Pose> posesBehind(std::optional<std::size_t> transmitter) const;
    [[nodiscard]] double largestRobot() const;
    [[nodiscard]] RadioReckoner& reckoner();

    const ShownWorld& m_world;
    const Selection& m_selection;
    const ViewSettings& m_settings;
    unsigned m_shown = 0; // of the three overlays
    std::shared_ptr<const std::vector<RadioNode>> m_nodes = std::make_shared<std::vector<RadioNode>>();
    std::vector<bool> m_selected;
    std::string m_transmitter; // path
    SceneOverlay m_inScene;
    double m_lobeUnit = 0;
    std::optional<RadioLinks> m_links;
    std::optional<CoverageMap> m_coverage;
    std::optional<CoverageWish> m_wanted;           // the last one
    std::vector<Pose> m_linkPoses, m_coveragePoses; // behind what was wanted last; none: nothing was
    std::uint64_t m_number = 0;                     // of the last wish
    std::uint64_t m_oldest = 0;                     // older answers are void
    std::uint64_t m_linkNumber = 0, m_coverageNumber = 0;
    bool m_linksAwaited = false, m_coverageAwaited = false;
    int m_givenUp = 0;
    std::unique_ptr<RadioReckoner> m_reckoner; // once it is needed; its thread ends before all else
};

} // namespace trundle
