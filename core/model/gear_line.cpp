// Method: what two gear wheels do to each other is one force in their pitch point, and its reactions pass through the bearings into the
// common body. So one row of a solver between the two ends, along a line that has the right moments about (or components along) both
// joints, is the whole gear: forces come in pairs, and no work is lost. For parallel axes the line is the tangent in the pitch point; for
// others it is the common normal of the axes, through the pitch point of the two cones; for a rack it is the rack.
#include "model/gear_line.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kParallel = 1e-4; // sine of the angle
constexpr double kSameLine = 1e-3; // m
constexpr double kSameShare = 1e-6;
constexpr double kSteep = 0.5; // of a slider across the hinge's axis; less is a screw

double momentAbout(const JointLine& line, const Vec3& point, const Vec3& force) {
    return line.axis.dot((point - line.point).cross(force));
}

std::optional<GearLine> betweenHinges(const JointLine& first, const JointLine& second, double share) {
    const Vec3 across = first.axis.cross(second.axis), apart = second.point - first.point;
    const double sine = across.norm(), size = std::clamp(apart.norm(), 0.01, 1.0);
    if (sine > kParallel) {
        const Vec3 normal = across / sine, foot = first.point + apart.cross(second.axis).dot(across) / (sine * sine) * first.axis;
        const double along = size / sine / std::max(1.0, std::abs(share));
        // The pitch cones meet on both sides of the foot: the wheels are on that of the anchors, whatever the senses of the axes.
        const Vec3 way = second.axis - share * first.axis;
        const bool isBehind = way.dot((first.point + second.point) / 2 - foot) < -kSameLine * way.norm();
        const double side = isBehind ? -along : along;
        const Vec3 point = foot - share * side * first.axis + side * second.axis;
        return GearLine{false, point, normal, momentAbout(first, point, normal)};
    }
    const double turned = first.axis.dot(second.axis) > 0 ? share : -share;
    if (std::abs(1 - turned) < kSameShare) return GearLine{true, first.point, first.axis, 1};
    const Vec3 side = apart - apart.dot(first.axis) * first.axis;
    const double distance = side.norm();
    if (distance < kSameLine) return std::nullopt;
    const double radius = distance / (1 - turned);
    return GearLine{false, first.point + radius / distance * side, first.axis.cross(side) / distance, radius};
}

/// Acts along the slider `share` times as it does about the hinge.
GearLine onRack(const JointLine& hinge, const JointLine& slider, double share) {
    const Vec3 across = slider.axis - slider.axis.dot(hinge.axis) * hinge.axis;
    const bool isScrew = across.norm() < kSteep;
    const Vec3 side = isScrew ? hinge.axis.unitOrthogonal() : Vec3(across.normalized());
    const Vec3 force = isScrew ? Vec3((slider.axis + side).normalized()) : side;
    const double lever = force.dot(slider.axis) / share;
    return {false, hinge.point + lever / force.dot(side) * side.cross(hinge.axis), force, lever};
}

std::optional<GearLine> betweenSliders(const JointLine& first, const JointLine& second, double share) {
    const double cosine = first.axis.dot(second.axis);
    if (first.axis.cross(second.axis).norm() < kParallel) {
        if (std::abs(share - cosine) > kSameShare) return std::nullopt;
        return GearLine{false, second.point, first.axis, 1};
    }
    const Vec3 force = ((share * cosine - 1) * first.axis + (cosine - share) * second.axis).normalized();
    return GearLine{false, second.point, force, force.dot(first.axis)};
}

} // namespace

std::optional<GearLine> gearLine(const JointLine& first, const JointLine& second, double share) {
    if (first.slides && second.slides) return betweenSliders(first, second, share);
    if (second.slides) return onRack(first, second, share);
    if (!first.slides) return betweenHinges(first, second, share);
    GearLine line = onRack(second, first, 1 / share);
    line.lever = line.direction.dot(first.axis);
    return line;
}

std::optional<GearEnds> gearEnds(int parent, int child, int otherParent, int otherChild) {
    GearEnds ends;
    if (parent == otherParent) ends = {child, otherChild, 1, 1};
    else if (parent == otherChild) ends = {child, otherParent, 1, -1};
    else if (child == otherParent) ends = {parent, otherChild, -1, 1};
    else if (child == otherChild) ends = {parent, otherParent, -1, -1};
    else return std::nullopt;
    if (ends.first == ends.second) return std::nullopt; // both are between the same bodies
    return ends;
}

std::optional<std::string> gearFault(const JointSpec& joint, const JointSpec& other, double ratio) {
    const auto ends = gearEnds(joint.parent, joint.child, other.parent, other.child);
    if (!ends)
        return joint.name + " and " + other.name + " need one body in common, such as the same Parent, that both wheels turn on";
    const auto lineOf = [](const JointSpec& j) { return JointLine{j.type == JointType::Slider, j.anchor, j.axis}; };
    if (gearLine(lineOf(joint), lineOf(other), ratio * ends->firstSense * ends->secondSense)) return std::nullopt;
    if (joint.type == JointType::Slider)
        return joint.name + " and " + other.name + " slide in parallel; put a wheel on a Hinge between them, with a Gear to each";
    return joint.name + " and " + other.name +
           " turn about the same line; put a wheel on a Hinge of its own line between them, with a Gear to each";
}

} // namespace trundle
