#include "world/rays/surface_normal.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

/// Of the face nearest to the point.
Vec3 ofBox(const double* half, const Vec3& p) {
    int axis = 0;
    for (int k = 1; k < 3; ++k)
        if (half[k] - std::abs(p[k]) < half[axis] - std::abs(p[axis])) axis = k;
    return Vec3::Unit(axis) * (p[axis] < 0 ? -1 : 1);
}

Vec3 ofCylinder(const RayShape& shape, const Vec3& p) {
    const double across = std::hypot(p.x(), p.y());
    if (shape.half[2] - std::abs(p.z()) < shape.radius - across) return Vec3::UnitZ() * (p.z() < 0 ? -1 : 1);
    return across > 0 ? Vec3(p.x() / across, p.y() / across, 0) : Vec3(Vec3::UnitX());
}

Vec3 ofHull(const RayShape& shape, const Vec3& p) {
    int face = 0;
    double nearest = -1e300;
    for (int f = 0; f < shape.planeCount; ++f) {
        const double* plane = shape.planes + 4 * f;
        const double height = Vec3(plane).dot(p) - plane[3];
        if (height > nearest) nearest = height, face = f;
    }
    return Vec3(shape.planes + 4 * face);
}

} // namespace

Vec3 normalOf(const RayShape& shape, const Vec3& point) {
    switch (shape.kind) {
    case RayShape::Box: return ofBox(shape.half, point);
    case RayShape::Sphere: return point.normalized();
    case RayShape::Cylinder: return ofCylinder(shape, point);
    case RayShape::Capsule: return (point - Vec3(0, 0, std::clamp(point.z(), -shape.half[2], shape.half[2]))).normalized();
    case RayShape::Hull: return ofHull(shape, point);
    default: return Vec3::UnitZ();
    }
}

} // namespace trundle
