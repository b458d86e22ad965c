#include "scene/queries/framing.h"

#include "scene/shapes/extents.h"

namespace trundle {
namespace {

// Statics up to kWholeRoom times the extent of the robots are framed completely; of larger ones only the part within
// kSurroundings.
constexpr double kWholeRoom = 20, kSurroundings = 7;

Bounds shownBounds(const GeomSpec& geom, const Pose& owner) { return geom.visible ? boundsOf(geom, owner) : Bounds{}; }

Vec3 placeFrom(const ComponentSpec& spec, std::string_view key, const Vec3& otherwise) {
    const ResolvedValue* value = spec.find(key);
    return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : otherwise;
}

/// World pose of the frame in which a View's numbers are written: the world, a robot's origin, or that origin with the robot's
/// heading.
Pose carrierOf(const ComponentSpec& view, const ExperimentSpec& experiment, const BodyPoses& poses) {
    const std::string mode = view.text("Mode"), name = view.text("Robot");
    std::size_t first = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        if (robot.name == name && mode != "fixed" && first < poses.size() && !robot.config->bodies.empty()) {
            const Pose frame = poses[first] * robot.config->bodies[0].pose.inverse();
            const double heading = hprFromRotation(frame.rotation).x();
            return {frame.position, rotationFromHpr({mode == "chase" ? heading : 0.0, 0, 0})};
        }
        first += robot.config->bodies.size();
    }
    return {};
}

} // namespace

std::optional<CameraView> namedView(const ExperimentSpec& experiment, std::string_view name, const BodyPoses& poses) {
    return namedView(experiment, name, experiment, poses);
}

std::optional<CameraView> namedView(const ExperimentSpec& text, std::string_view name, const ExperimentSpec& running,
                                    const BodyPoses& poses) {
    for (const ComponentSpec& spec : text.looks) {
        if (spec.kind != "View" || spec.name != name) continue;
        const Pose carrier = carrierOf(spec, running, poses);
        CameraView view;
        view.eye = carrier * placeFrom(spec, "Eye", view.eye);
        view.target = carrier * placeFrom(spec, "Target", view.target);
        view.fieldOfView = spec.number("FieldOfView", view.fieldOfView);
        return view;
    }
    return std::nullopt;
}

std::string viewNames(const ExperimentSpec& experiment) {
    std::string names;
    for (const ComponentSpec& spec : experiment.looks)
        if (spec.kind == "View" && names.size() < 200) names += (names.empty() ? "" : ", ") + spec.name;
    return names;
}

CameraView defaultView(const ExperimentSpec& experiment, const BodyPoses& poses, std::uint32_t width, std::uint32_t height) {
    Bounds robots, statics;
    std::size_t body = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& spec : robot.config->bodies) {
            if (body >= poses.size()) break;
            for (const GeomSpec& geom : spec.geoms) robots.add(shownBounds(geom, poses[body]));
            ++body;
        }
    }
    for (const StaticSpec& fixed : experiment.statics) {
        if (fixed.geoms)
            for (const GeomSpec& geom : *fixed.geoms) statics.add(shownBounds(geom, fixed.pose));
    }
    Bounds all = robots;
    if (robots.empty()) {
        all = statics;
    } else if (!statics.empty()) {
        const double extent = std::max(robots.radius(), 0.05);
        Bounds near = robots;
        near.grow(extent * (statics.radius() <= kWholeRoom * extent ? 2 * kWholeRoom : kSurroundings));
        all.add(Bounds{statics.low.cwiseMax(near.low).cwiseMin(near.high), statics.high.cwiseMin(near.high).cwiseMax(near.low)});
    }
    return viewOf(all, width, height);
}

} // namespace trundle
