#pragma once
// Preview of configs, which can be viewed, run and driven: the one that the model editor shows, or of a text without instances
// each robot and arena of the opened file. Each is under its own path ("RobotConfig.Rover"), side by side, the robots on a floor.
// Floor and instances exist only in the preview.

#include <memory>

#include "app/application.h"

namespace trundle {

class Document;

/// The config of the floor, which cannot be selected since it is in no file.
inline constexpr const char* kPreviewFloor = "TrundlePreviewFloor";
inline constexpr const char* kPreviewRamp = "TrundlePreviewRamp"; ///< the same of the ramp

class PreviewScene {
public:
    explicit PreviewScene(Application& application) : m_application(application) {} ///< `application` must outlive this

    /// A preview of the edited model, which can run like any other project; without one the document's project or, if that has no
    /// instances, a preview of its configs. Null if nothing is open.
    [[nodiscard]] std::shared_ptr<const LoadedProject> show(const Document& document);
    /// Ahead of the edited model the floor rises to a ramp, degrees; 0: nowhere. In proportion to the robot: as wide as three of it.
    void setRamp(double slope);
    /// The experiment of the newest text without errors; null if there was none.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastValid(const Document& document) const;

private:
    Application& m_application;
    std::shared_ptr<const LoadedProject> m_of, m_shown;
    std::string m_model; // path of the edited model that m_shown shows alone
    double m_ramp = 0;   // degrees
    std::shared_ptr<const LoadedProject> m_read;  // the project that m_shown was made from; null if the document's own is shown
    std::shared_ptr<const ExperimentSpec> m_good; // of a preview
};

} // namespace trundle
