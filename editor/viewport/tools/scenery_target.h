#pragma once
#include <string>

#include <QString>

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

/// Whether the scenery that is shown has a Plane or a Heightfield.
[[nodiscard]] bool hasFloor(const ViewportScene& world);

/// New scenery as one entry of the history: into the experiment `blocks`, a StaticConfig and its Static, which is selected; into a
/// StaticConfig the geoms `insideConfig`. Both use common materials and surfaces. A refusal is reported by Document::refused().
void insertScenery(Document& document, const SceneryTarget& target, const QString& title, const std::string& blocks,
                   const std::string& insideConfig);

} // namespace trundle
