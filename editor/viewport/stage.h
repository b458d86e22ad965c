#pragma once
// What a text that places nothing describes, put up to be looked at: each robot and arena of the opened file under its own path
// ("RobotConfig.Rover"), side by side. Nothing of it stands in a text, and nothing of it runs.

#include <memory>

#include "parts/parts.h"

namespace trundle {

class Document;

class Stage {
public:
    explicit Stage(Parts& parts) : m_parts(parts) {} ///< `parts` outlive this

    /// The document's experiment; where it places nothing, with what it describes.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> show(const Document& document);
    /// The same of the newest text that had no errors; null before there was one.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> lastGood(const Document& document) const;

private:
    Parts& m_parts;
    std::shared_ptr<const Loaded> m_of, m_staged;          // m_staged: null where there is nothing on the stage
    std::shared_ptr<const ExperimentSpec> m_shown, m_good; // m_good: of the stage
};

} // namespace trundle
