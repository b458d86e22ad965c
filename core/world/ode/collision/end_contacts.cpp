#include "world/ode/collision/end_contacts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace trundle {

namespace {

constexpr int kPoints = 32;         // of a rim
constexpr double kSameDepth = 5e-5; // m; smaller differences are decided by index, so that the choice is stable between ticks
constexpr double kSamePlace = 1e-6; // m
constexpr double kLeastTilt = 0.05; // sine of a tilt with a lowest point

using Circle = std::array<std::pair<double, double>, kPoints>;

Circle unitCircle() {
    Circle circle;
    for (int i = 0; i < kPoints; ++i) {
        const double angle = i * 2 * std::numbers::pi / kPoints;
        circle[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    return circle;
}

/// Calls `each` with points of the rim.
template <class Each> void forRim(const RoundEnd& end, Each each) {
    static const Circle circle = unitCircle();
    const Vec3 about = std::abs(end.outward.x()) < 0.7 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 u = about.cross(end.outward).normalized(), v = end.outward.cross(u);
    for (const auto& [x, y] : circle) each(Vec3(end.centre + end.radius * (x * u + y * v)));
}

struct Ground {
    Vec3 normal;
    double offset = 0;

    /// Whether all of an end is above.
    [[nodiscard]] bool isBelow(const RoundEnd& end) const {
        const double rise = normal.dot(end.outward);
        return normal.dot(end.centre) - offset > end.radius * std::sqrt(std::max(0.0, 1 - rise * rise));
    }
    void add(const Vec3& point, std::vector<SurfaceContact>& contacts) const {
        if (const double depth = offset - normal.dot(point); depth >= 0) contacts.push_back({point, normal, depth});
    }
};

bool isOver(const RoundEnd& end, const Vec3& point) {
    const Vec3 from = point - end.centre;
    return (from - from.dot(end.outward) * end.outward).squaredNorm() <= end.radius * end.radius;
}

/// The point of the end above one of the ground.
Vec3 ofEnd(const RoundEnd& end, const Vec3& point, const Vec3& up) {
    return point + (end.centre - point).dot(end.outward) / up.dot(end.outward) * up;
}

/// Of the end, where its rim crosses the edges of the side, and over the corners that it covers.
void addEdges(const RoundEnd& end, const BoxSide& side, const Ground& ground, std::vector<SurfaceContact>& contacts) {
    const Vec3 from = end.centre - side.centre;
    const double x = from.dot(side.along), y = from.dot(side.across);
    const auto add = [&](double along, double across) {
        const Vec3 point = side.centre + along * side.along + across * side.across;
        ground.add(ofEnd(end, point, side.outward), contacts);
    };
    for (const double sign : {-1.0, 1.0}) {
        const double a = sign * side.halfAlong, b = sign * side.halfAcross;
        const double beyondA = end.radius * end.radius - (a - x) * (a - x), beyondB = end.radius * end.radius - (b - y) * (b - y);
        for (const double way : {-1.0, 1.0}) {
            if (const double at = y + way * std::sqrt(std::max(0.0, beyondA)); beyondA > 0 && std::abs(at) < side.halfAcross)
                add(a, at);
            if (const double at = x + way * std::sqrt(std::max(0.0, beyondB)); beyondB > 0 && std::abs(at) < side.halfAlong)
                add(at, b);
            const double corner = way * side.halfAcross;
            if (std::hypot(a - x, corner - y) <= end.radius) add(a, corner);
        }
    }
}

} // namespace

void endOnPlane(const RoundEnd& end, const Vec3& normal, double offset, std::vector<SurfaceContact>& contacts) {
    const Ground ground{normal, offset};
    if (ground.isBelow(end)) return;
    if (const Vec3 down = normal.dot(end.outward) * end.outward - normal;
        down.norm() > kLeastTilt) // first, so that it is the deepest
        ground.add(end.centre + end.radius * down.normalized(), contacts);
    forRim(end, [&](const Vec3& point) { ground.add(point, contacts); });
}

void endOnSide(const RoundEnd& end, const BoxSide& side, std::vector<SurfaceContact>& contacts) {
    const Ground ground{side.outward, side.outward.dot(side.centre)};
    if (ground.isBelow(end)) return;
    forRim(end, [&](const Vec3& point) {
        const Vec3 from = point - side.centre;
        if (std::abs(from.dot(side.along)) <= side.halfAlong && std::abs(from.dot(side.across)) <= side.halfAcross)
            ground.add(point, contacts);
    });
    addEdges(end, side, ground, contacts);
}

void endOnEnd(const RoundEnd& first, const RoundEnd& second, std::vector<SurfaceContact>& contacts) {
    const Ground ground{second.outward, second.outward.dot(second.centre)};
    forRim(first, [&](const Vec3& point) {
        if (isOver(second, point)) ground.add(point, contacts);
    });
    forRim(second, [&](const Vec3& point) {
        if (isOver(first, point)) ground.add(ofEnd(first, point, second.outward), contacts);
    });
}

void keepWidest(std::vector<SurfaceContact>& contacts, int most) {
    if (contacts.size() < 2) return;
    const auto farthest = [&](auto how) { return *std::ranges::max_element(contacts, {}, how); };
    const SurfaceContact deepest = farthest([](const SurfaceContact& c) { return std::floor(c.depth / kSameDepth); });
    const SurfaceContact other = farthest([&](const SurfaceContact& c) { return (c.position - deepest.position).squaredNorm(); });
    const Vec3 aside = deepest.normal.cross(other.position - deepest.position).normalized();
    const auto side = [&](const SurfaceContact& c) { return aside.dot(c.position - deepest.position); };
    const auto otherSide = [&](const SurfaceContact& c) { return -side(c); };
    const SurfaceContact left = farthest(side), right = farthest(otherSide);
    const bool hasLeft = most > 2 && side(left) > kSamePlace, hasRight = most > 2 && side(right) < -kSamePlace;
    contacts.assign({deepest, other});
    if (hasLeft) contacts.push_back(left);
    if (hasRight) contacts.push_back(right);
}

} // namespace trundle
