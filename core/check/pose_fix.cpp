#include "check/pose_fix.h"

#include <cmath>

#include "lang/tree_edit.h"
#include "project/edits/moved_block.h"
#include "project/objects/part_values.h"

namespace trundle {

namespace {

constexpr double kGrain = 1e-4; // m

/// Rounds a shift away from zero, so that `from + shift` is a multiple of kGrain.
double roundedShift(double from, double shift) {
    if (std::abs(shift) < 1e-9) return 0;
    const double to = (from + shift) / kGrain;
    const double grains = shift > 0 ? std::ceil(to - 1e-6) : std::floor(to + 1e-6);
    return grains * kGrain - from;
}

} // namespace

std::optional<Fix> moveFix(const LoadedProject& loaded, const RobotSpec& robot, const Vec3& offset) {
    std::optional<ObjectLocation> place = placeOf(loaded, robot.name);
    if (!place || !place->part || !place->around.empty()) return std::nullopt; // of a Repeat: it would move all members
    const bool sideways = std::abs(offset.x()) > 1e-9 || std::abs(offset.y()) > 1e-9;
    const bool layout = place->part->is(Role::Layout);
    if (layout && (sideways || place->part->kind->name != "Grid")) return std::nullopt;
    const Part& part = *place->part;
    if (part.file >= loaded.paths.size() || loaded.paths[part.file].empty()) return std::nullopt;

    place->member = false; // edit the layout's pose, not that of a member
    const Vec3 from = poseAt(loaded, *place).position;
    Vec3 shift;
    for (int k = 0; k < 3; ++k) shift[k] = roundedShift(from[k], offset[k]);
    const SourceAssignment* a = part.assignments.find("Pos");
    if (!a) {
        const std::string text = positionText(from + shift);
        return Fix{"Pos=" + text, {editAddAssignment(*loaded.trees[part.file], part.block, "Pos", text)}};
    }
    if (a->file >= loaded.paths.size() || loaded.paths[a->file].empty()) return std::nullopt;
    const auto text = shiftedPosition(*a->value, loaded.trees[a->file]->source().bytes(), shift);
    if (!text) return std::nullopt;
    return Fix{"Pos=" + *text, {{a->valueRange(), *text}}};
}

} // namespace trundle
