#include "world/floor_marks.h"

#include <cmath>

namespace trundle {

namespace {

constexpr double kThickest = 0.002; // m
constexpr double kGap = 0.0005;     // m, from the surface

Vec3 halfOf(const GeomSpec& geom) {
    return geom.shape == GeomShape::Box ? Vec3(geom.size / 2) : Vec3(geom.radius, geom.radius, geom.length / 2);
}

bool isWithin(const FloorMarks::Mark& mark, const Vec3& point) {
    if ((point.array() < mark.low.array()).any() || (point.array() > mark.high.array()).any()) return false;
    const Vec3 at = mark.X_WG.inverse() * point, half = halfOf(*mark.geom);
    if (std::abs(at.z()) > half.z() + kGap) return false;
    if (mark.geom->shape == GeomShape::Cylinder) return std::hypot(at.x(), at.y()) <= half.x();
    return std::abs(at.x()) <= half.x() && std::abs(at.y()) <= half.y();
}

} // namespace

void FloorMarks::add(const GeomSpec& geom, const Pose& X_WG) {
    const bool isFlat = geom.shape == GeomShape::Box || geom.shape == GeomShape::Cylinder;
    if (geom.collide || !geom.visible || !isFlat || 2 * halfOf(geom).z() > kThickest) return;
    const Vec3 half = X_WG.rotation.toRotationMatrix().cwiseAbs() * (halfOf(geom) + Vec3(0, 0, kGap));
    m_marks.push_back({&geom, X_WG, X_WG.position - half, X_WG.position + half});
}

const FloorMarks::Mark* FloorMarks::at(const Vec3& point) const {
    const Mark* best = nullptr;
    for (const Mark& mark : m_marks)
        if (isWithin(mark, point) && (!best || mark.high.z() >= best->high.z())) best = &mark;
    return best;
}

} // namespace trundle
