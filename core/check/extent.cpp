#include "check/extent.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

/// Extent of a mesh's points along a direction in the geom's frame.
Extent extentOfPoints(const TriangleMesh& mesh, const Vec3& direction) {
    Extent extent{HUGE_VAL, -HUGE_VAL};
    for (const auto& p : mesh.points) {
        const double at = direction.dot(Vec3(p[0], p[1], p[2]));
        extent.low = std::min(extent.low, at);
        extent.high = std::max(extent.high, at);
    }
    return mesh.points.empty() ? Extent{} : extent;
}

} // namespace

Extent extentAlong(const GeomSpec& geom, const Pose& X_WG, const Vec3& direction) {
    const Vec3 d = X_WG.rotation.conjugate() * direction; // in the geom's frame
    const double centre = direction.dot(X_WG.position);
    double half = 0;
    switch (geom.shape) {
    case GeomShape::Box: half = 0.5 * d.cwiseAbs().dot(geom.size); break;
    case GeomShape::Sphere: half = geom.radius; break;
    case GeomShape::Capsule: half = geom.radius + 0.5 * geom.length * std::abs(d.z()); break;
    case GeomShape::Cylinder:
        half = 0.5 * geom.length * std::abs(d.z()) + geom.radius * std::sqrt(std::max(0.0, 1 - d.z() * d.z()));
        break;
    case GeomShape::Convex:
    case GeomShape::Mesh:
        if (const auto& mesh = geom.hull ? geom.hull : geom.mesh) {
            const Extent points = extentOfPoints(*mesh, d);
            return {centre + points.low, centre + points.high};
        }
        break;
    case GeomShape::Plane:
    case GeomShape::Heightfield: break;
    }
    return {centre - half, centre + half};
}

Extent extentAlong(const RobotConfigSpec& config, const Pose& X_WR, const Vec3& direction) {
    Extent all{HUGE_VAL, -HUGE_VAL};
    for (const BodySpec& body : config.bodies)
        for (const GeomSpec& geom : body.geoms) {
            if (!geom.collide) continue;
            const Extent extent = extentAlong(geom, X_WR * body.pose * geom.pose, direction);
            all = {std::min(all.low, extent.low), std::max(all.high, extent.high)};
        }
    return all;
}

BodyBox boxAround(const BodySpec& body) {
    BodyBox box{Vec3::Constant(HUGE_VAL), Vec3::Constant(-HUGE_VAL)};
    for (const GeomSpec& geom : body.geoms)
        for (int k = 0; k < 3; ++k) {
            const Extent extent = extentAlong(geom, geom.pose, Vec3::Unit(k));
            box.low[k] = std::min(box.low[k], extent.low);
            box.high[k] = std::max(box.high[k], extent.high);
        }
    return box;
}

double smallestWidth(const GeomSpec& geom) {
    switch (geom.shape) {
    case GeomShape::Box: return geom.size.minCoeff();
    case GeomShape::Sphere:
    case GeomShape::Capsule: return 2 * geom.radius;
    case GeomShape::Cylinder: return std::min(2 * geom.radius, geom.length);
    case GeomShape::Convex:
    case GeomShape::Mesh: {
        double width = HUGE_VAL;
        for (int k = 0; k < 3; ++k) {
            const Extent e = extentAlong(geom, {}, Vec3::Unit(k));
            width = std::min(width, e.high - e.low);
        }
        return width;
    }
    case GeomShape::Plane:
    case GeomShape::Heightfield: break;
    }
    return HUGE_VAL;
}

} // namespace trundle
