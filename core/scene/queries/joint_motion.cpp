#include "scene/queries/joint_motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

namespace trundle {
namespace {

constexpr double kFreeAngle = std::numbers::pi, kFreeLength = 0.1; // of a coordinate without stops, to each side

JointCoordinate coordinateOf(std::size_t joint, int part, bool isAngle, std::optional<double> low, std::optional<double> high) {
    const double free = isAngle ? kFreeAngle : kFreeLength;
    JointCoordinate made{joint, part, isAngle, low.value_or(-free), high.value_or(free), low.has_value(), high.has_value()};
    if (!low && made.low >= made.high) made.low = made.high - free;
    if (!high && made.high <= made.low) made.high = made.low + free;
    return made;
}

Pose turnAbout(const Vec3& anchor, const Quat& turn) { return {anchor - turn * anchor, turn}; }
Pose turnAbout(const Vec3& anchor, const Vec3& axis, double angle) {
    return turnAbout(anchor, Quat(Eigen::AngleAxisd(angle, axis)));
}

/// The rotation of a Ball, whose axis tilts no farther than SwingStop.
Quat swung(const JointSpec& joint, const Vec3& turn) {
    const double angle = turn.norm();
    if (angle < 1e-12) return Quat::Identity();
    const Quat whole(Eigen::AngleAxisd(angle, turn / angle));
    if (!joint.swingStop) return whole;
    const Vec3 tilted = whole * joint.axis, about = joint.axis.cross(tilted);
    const double tilt = std::atan2(about.norm(), joint.axis.dot(tilted)), excess = tilt - *joint.swingStop;
    if (excess <= 0 || about.norm() < 1e-12) return whole;
    return Quat(Eigen::AngleAxisd(-excess, about.normalized())) * whole;
}

/// From where the child is at the start to where it is, for a parent that has not moved.
Pose motionOf(const JointSpec& joint, const std::array<double, 3>& q) {
    switch (joint.type) {
    case JointType::Hinge: return turnAbout(joint.anchor, joint.axis, q[0]);
    case JointType::Slider: return {q[0] * joint.axis, Quat::Identity()};
    case JointType::Universal: return turnAbout(joint.anchor, joint.axis, q[0]) * turnAbout(joint.anchor, joint.axis2, q[1]);
    case JointType::Suspension: return Pose{q[0] * joint.axis, Quat::Identity()} * turnAbout(joint.anchor, joint.axis2, q[1]);
    case JointType::Ball: return turnAbout(joint.anchor, swung(joint, Vec3(q.data())));
    case JointType::Fixed: break;
    }
    return {};
}

} // namespace

std::vector<JointCoordinate> jointCoordinates(const RobotConfigSpec& config) {
    std::vector<JointCoordinate> all;
    for (std::size_t j = 0; j < config.joints.size(); ++j) {
        const JointSpec& joint = config.joints[j];
        switch (joint.type) {
        case JointType::Hinge: all.push_back(coordinateOf(j, 0, true, joint.lowStop, joint.highStop)); break;
        case JointType::Slider: all.push_back(coordinateOf(j, 0, false, joint.lowStop, joint.highStop)); break;
        case JointType::Universal:
            all.push_back(coordinateOf(j, 0, true, joint.lowStop, joint.highStop));
            all.push_back(coordinateOf(j, 1, true, joint.lowStop2, joint.highStop2));
            break;
        case JointType::Suspension: {
            const auto travel = joint.travel > 0 ? std::optional(joint.travel) : std::nullopt;
            all.push_back(coordinateOf(j, 0, false, travel ? std::optional(-*travel) : travel, travel));
            all.push_back(coordinateOf(j, 1, true, std::nullopt, std::nullopt));
            break;
        }
        case JointType::Ball:
            for (int part = 0; part < 3; ++part) all.push_back(coordinateOf(j, part, true, std::nullopt, std::nullopt));
            break;
        case JointType::Fixed: break;
        }
    }
    return all;
}

void setJointPosition(const RobotConfigSpec& config, std::span<const JointCoordinate> coordinates, std::size_t which,
                      double position, std::span<double> positions) {
    std::vector<bool> done(coordinates.size());
    const auto indexOf = [&](int joint) {
        const auto at =
            std::ranges::find_if(coordinates, [&](const JointCoordinate& c) { return c.joint == std::size_t(joint); });
        return std::size_t(at - coordinates.begin());
    };
    std::vector<std::pair<std::size_t, double>> next{{which, position}};
    while (!next.empty()) {
        const auto [at, wanted] = next.back();
        next.pop_back();
        if (at >= coordinates.size() || done[at]) continue;
        done[at] = true;
        const double reached = std::clamp(wanted, coordinates[at].low, coordinates[at].high);
        positions[at] = coordinates[at].hasLow || coordinates[at].hasHigh || at == which ? reached : wanted;
        if (coordinates[at].part != 0) continue;
        for (const GearSpec& gear : config.gears) { // position = ratio * other's position
            if (std::size_t(gear.joint) == coordinates[at].joint)
                next.push_back({indexOf(gear.other), positions[at] / gear.ratio});
            if (std::size_t(gear.other) == coordinates[at].joint)
                next.push_back({indexOf(gear.joint), positions[at] * gear.ratio});
        }
    }
}

std::vector<Pose> bodyMotions(const RobotConfigSpec& config, std::span<const JointCoordinate> coordinates,
                              std::span<const double> positions) {
    std::vector<std::array<double, 3>> q(config.joints.size(), {0, 0, 0});
    for (std::size_t i = 0; i < coordinates.size() && i < positions.size(); ++i)
        q[coordinates[i].joint][std::size_t(coordinates[i].part)] = positions[i];
    std::vector<std::optional<Pose>> motions(config.bodies.size());
    const auto follow = [&] { // from what has moved to what is joined to it, either way
        for (bool changed = true; changed;) {
            changed = false;
            for (std::size_t j = 0; j < config.joints.size(); ++j) {
                const JointSpec& joint = config.joints[j];
                std::optional<Pose>& child = motions[std::size_t(joint.child)];
                const bool hasParent = joint.parent == kWorldBody || motions[std::size_t(joint.parent)].has_value();
                if (hasParent == child.has_value()) continue;
                changed = true;
                const Pose own = motionOf(joint, q[j]);
                if (hasParent) child = joint.parent == kWorldBody ? own : *motions[std::size_t(joint.parent)] * own;
                else motions[std::size_t(joint.parent)] = *child * own.inverse();
            }
        }
    };
    const bool isHeld = std::ranges::any_of(config.joints, [](const JointSpec& joint) { return joint.parent == kWorldBody; });
    if (isHeld) follow();
    for (std::optional<Pose>& motion : motions) {
        if (motion) continue;
        motion = Pose{};
        follow();
    }
    std::vector<Pose> all;
    for (const std::optional<Pose>& motion : motions) all.push_back(*motion);
    return all;
}

} // namespace trundle
