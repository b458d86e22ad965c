#pragma once
#include <string>

#include <trundle/geometry.h>

namespace trundle {

class Document;
class ViewportScene;

/// Where new scenery is written to, and its frame in W.
struct SceneryTarget {
    std::string path; ///< of a StaticConfig; empty: the experiment
    Pose X_WP;
};
/// The StaticConfig that is shown alone, by the model editor or because nothing is placed; otherwise the experiment.
[[nodiscard]] SceneryTarget sceneryTarget(const Document& document, const ViewportScene& world);

/// Whether there is a document and scenery can be in what is shown; otherwise the reason is reported by Document::refused().
[[nodiscard]] bool canHaveScenery(Document& document);

} // namespace trundle
