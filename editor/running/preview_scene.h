#pragma once
// A text that places nothing, put up to be looked at, run and driven: each robot and arena of the opened file under its own path
// ("RobotConfig.Rover"), side by side, the robots on a floor. Floor and instances come from here; no text has them.

#include <memory>

#include "parts/parts.h"

namespace trundle {

class Document;

/// The config of the floor, which is part of no text: nothing of it can be selected.
inline constexpr const char* kPreviewFloor = "TrundlePreviewFloor";

class PreviewScene {
public:
    explicit PreviewScene(Parts& parts) : m_parts(parts) {} ///< `parts` outlive this

    /// What the document means; where it places nothing, a scene of what it describes, which runs like any other. Null where nothing
    /// is open.
    [[nodiscard]] std::shared_ptr<const Loaded> show(const Document& document);
    /// The experiment of the newest text that had no errors; null before there was one.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastGood(const Document& document) const;

private:
    Parts& m_parts;
    std::shared_ptr<const Loaded> m_of, m_shown;
    std::shared_ptr<const Loaded> m_read;         // of which m_shown is arranged; null where the document's own is shown
    std::shared_ptr<const ExperimentSpec> m_good; // of a preview
};

} // namespace trundle
