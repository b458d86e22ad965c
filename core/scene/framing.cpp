#include "scene/framing.h"

namespace trundle {
namespace {

// Statics up to this many times the extent of the robots are framed whole; of larger ones only what is near the robots.
constexpr double kWholeRoom = 20, kSurroundings = 7;

double reachOf(const GeomSpec& g) {
    switch (g.shape) {
    case GeomShape::Sphere: return g.radius;
    case GeomShape::Cylinder: return std::hypot(g.radius, 0.5 * g.length);
    case GeomShape::Capsule: return g.radius + 0.5 * g.length;
    default: return 0;
    }
}

/// Box of a geom in the world; round shapes by the ball around them.
Bounds boundsOf(const GeomSpec& geom, const Pose& owner) {
    Bounds bounds;
    const Pose pose = owner * geom.pose;
    if (!geom.visible || !pose.position.allFinite() || !pose.rotation.coeffs().allFinite()) return bounds;
    const auto addBox = [&](const Vec3& low, const Vec3& high) {
        for (int i = 0; i < 8; ++i) bounds.add(pose * Bounds{low, high}.corner(i));
    };
    switch (geom.shape) {
    case GeomShape::Plane: break;
    case GeomShape::Box: addBox(-0.5 * geom.size, 0.5 * geom.size); break;
    case GeomShape::Heightfield:
        addBox({-0.5 * geom.size.x(), -0.5 * geom.size.y(), 0}, {0.5 * geom.size.x(), 0.5 * geom.size.y(), geom.size.z()});
        break;
    case GeomShape::Mesh:
    case GeomShape::Convex:
        if (geom.mesh) for (const auto& p : geom.mesh->points) bounds.add(pose * Vec3(p[0], p[1], p[2]));
        break;
    default: bounds.add(pose.position); bounds.grow(reachOf(geom)); break;
    }
    return bounds.empty() || !bounds.low.allFinite() || !bounds.high.allFinite() ? Bounds{} : bounds;
}

} // namespace

CameraView defaultView(const ExperimentSpec& experiment, const BodyPoses& poses, std::uint32_t width, std::uint32_t height) {
    Bounds robots, statics;
    std::size_t body = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& spec : robot.config->bodies) {
            if (body >= poses.size()) break;
            for (const GeomSpec& geom : spec.geoms) robots.add(boundsOf(geom, poses[body]));
            ++body;
        }
    }
    for (const StaticSpec& fixed : experiment.statics) {
        if (fixed.geoms) for (const GeomSpec& geom : *fixed.geoms) statics.add(boundsOf(geom, fixed.pose));
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
