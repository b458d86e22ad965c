#include <algorithm>

#include "check/checks.h"
#include "project/edits/value_edits.h"
#include "project/objects/part_values.h"

namespace trundle {

bool reportedGravity(const LoadedProject& loaded, Diagnostics& diagnostics) {
    const ExperimentSpec& experiment = *loaded.experiment;
    const Vec3 gravity = experiment.settings.gravity;
    const StaticSpec* floor = nullptr;
    for (const StaticSpec& object : experiment.statics)
        for (const GeomSpec& geom : object.geoms ? *object.geoms : std::vector<GeomSpec>()) {
            if (geom.shape != GeomShape::Plane || !geom.collide) continue;
            const Vec3 normal = (object.pose * geom.pose).rotation * Vec3::UnitZ();
            if (normal.dot(gravity) <= 0.9 * gravity.norm()) return false;
            floor = &object;
        }
    if (!floor || gravity.isZero()) return false;
    const std::string down = positionText(-gravity);
    const auto edits = editsForValues(loaded, {{DottedPath("Gravity"), ParsedValue(down)}});
    const bool isHere = edits.ok() && edits.value().size() == 1 && edits.value().begin()->second.size() == 1;
    const SourceRange place = isHere ? edits.value().begin()->second.front().range : floor->nameRange;
    Diagnostic& d = diagnostics.warning(Code::Unsupported, place,
                                        "Gravity=" + positionText(gravity) + " points out of " + floor->name +
                                            ": robots fall away from it; Gravity=" + down + " points into it");
    if (isHere) d.fixes.push_back({"Gravity=" + down, edits.value().begin()->second});
    return true;
}

} // namespace trundle
