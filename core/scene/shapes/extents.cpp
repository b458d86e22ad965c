#include "scene/shapes/extents.h"

#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr double kPlaceholderHalf = 0.05; // m

/// Half the extent of a rotationally symmetric shape along each world axis (m).
Vec3 roundReach(const GeomSpec& g, const Mat3& turn) {
    Vec3 reach;
    for (int i = 0; i < 3; ++i) {
        const double along = std::abs(turn(i, 2)), across = std::sqrt(std::max(0.0, 1 - along * along));
        switch (g.shape) {
        case GeomShape::Cylinder: reach[i] = 0.5 * g.length * along + g.radius * across; break;
        case GeomShape::Capsule: reach[i] = 0.5 * g.length * along + g.radius; break;
        default: reach[i] = g.radius; break;
        }
    }
    return reach;
}

} // namespace

Bounds boundsOf(const GeomSpec& geom, const Pose& owner) {
    Bounds bounds;
    if (!geom.pose.position.allFinite() || !geom.pose.rotation.coeffs().allFinite()) return bounds;
    const Pose pose = owner * geom.pose;
    const auto addBox = [&](const Vec3& low, const Vec3& high) {
        const Bounds box{low, high};
        for (int i = 0; i < 8; ++i) bounds.add(pose * box.corner(i));
    };
    if (geom.shape == GeomShape::Plane) return bounds;
    if (isPlaceholder(geom)) {
        addBox(Vec3::Constant(-kPlaceholderHalf), Vec3::Constant(kPlaceholderHalf));
    } else if (geom.shape == GeomShape::Box) {
        addBox(-0.5 * geom.size, 0.5 * geom.size);
    } else if (geom.shape == GeomShape::Heightfield) {
        addBox({-0.5 * geom.size.x(), -0.5 * geom.size.y(), 0}, {0.5 * geom.size.x(), 0.5 * geom.size.y(), geom.size.z()});
    } else if (geom.shape == GeomShape::Mesh || geom.shape == GeomShape::Convex) {
        for (const auto& p : geom.mesh->points) bounds.add(pose * Vec3(p[0], p[1], p[2]));
    } else {
        const Vec3 reach = roundReach(geom, pose.rotation.toRotationMatrix());
        bounds = {pose.position - reach, pose.position + reach};
    }
    return bounds.empty() || !bounds.low.allFinite() || !bounds.high.allFinite() ? Bounds{} : bounds;
}

Ball ballAround(const GeomSpec& geom) {
    if (geom.shape == GeomShape::Plane) return {geom.pose.position, std::numeric_limits<double>::infinity()};
    const Bounds box = boundsOf(geom, Pose{});
    return box.empty() ? Ball{} : Ball{box.centre(), box.radius()};
}

} // namespace trundle
