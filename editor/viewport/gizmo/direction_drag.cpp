#include "editor/viewport/gizmo/direction_drag.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace trundle {
namespace {

constexpr double kSnapAngle = 8 * std::numbers::pi / 180; // to a main axis

double toStep(double angle, double step) { return step > 0 ? step * std::round(angle / step) : angle; }

std::optional<Vec3> nearMainAxis(const Vec3& direction) {
    int axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    const Vec3 main = (direction[axis] < 0 ? -1.0 : 1.0) * Vec3::Unit(axis);
    return std::acos(std::clamp(direction.dot(main), -1.0, 1.0)) < kSnapAngle ? std::optional(main) : std::nullopt;
}

} // namespace

std::array<Vec3, 2> directionsUnder(const ViewRay& ray, const Vec3& centre, const Vec3& before, double length) {
    const Vec3 nearest = ray.origin + ray.direction.dot(centre - ray.origin) * ray.direction - centre;
    if (nearest.norm() >= length) return {nearest.normalized(), nearest.normalized()};
    const double depth = std::sqrt(length * length - nearest.squaredNorm()), side = ray.direction.dot(before) <= 0 ? -1 : 1;
    const Vec3 there = side * depth * ray.direction;
    return {(nearest + there).normalized(), (nearest - there).normalized()};
}

Vec3 snappedDirection(const std::array<Vec3, 2>& directions, double stepDegrees) {
    for (const Vec3& direction : directions)
        if (const auto main = nearMainAxis(direction)) return *main;
    const Vec3& first = directions[0];
    const double step = stepDegrees * std::numbers::pi / 180;
    const double up = toStep(std::asin(std::clamp(first.z(), -1.0, 1.0)), step),
                 heading = toStep(std::atan2(first.y(), first.x()), step);
    Vec3 turned(std::cos(up) * std::cos(heading), std::cos(up) * std::sin(heading), std::sin(up));
    for (int k = 0; k < 3; ++k)
        if (std::abs(turned[k]) < 1e-12) turned[k] = 0;
    return turned;
}

} // namespace trundle
