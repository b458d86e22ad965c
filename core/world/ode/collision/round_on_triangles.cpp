#include "world/ode/collision/round_on_triangles.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>

#include "world/ode/collision/contact_choice.h"
#include "world/ode/collision/end_contacts.h"

namespace trundle {

namespace {

constexpr double kSamePlane = 2e-5; // of the radius: how far off a plane a point of it may be
constexpr double kSameWay = 0.97;   // cosine; contacts of a wheel with the same direction
constexpr double kMostDiscs = 9;    // of a cylinder
constexpr double kRim = 0.98;       // of half the width
constexpr double kTilt = 0.3;       // of half the width: as much deeper a rim has to be than the middle, 17 degrees

/// The nearest point of a triangle, or of its cut with the plane of a wheel.
struct Nearest {
    Vec3 point, normal; ///< of the triangle
    double distance = 0;
    bool inside = false; ///< of the triangle, not on its edge
};

Vec3 normalOf(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).normalized(); }

Vec3 nearestOnLine(const Vec3& a, const Vec3& b, const Vec3& centre, bool& inside) {
    const Vec3 way = b - a;
    const double length2 = way.squaredNorm(), along = length2 > 0 ? (centre - a).dot(way) / length2 : 0;
    inside = along > 0 && along < 1;
    return a + std::clamp(along, 0.0, 1.0) * way;
}

Nearest nearestOnTriangle(const Triangle& t, const Vec3& normal, const Vec3& centre) {
    Nearest nearest{centre - normal.dot(centre - t[0]) * normal, normal, 0, true};
    for (std::size_t k = 0; k < 3; ++k)
        nearest.inside = nearest.inside && (t[(k + 1) % 3] - t[k]).cross(nearest.point - t[k]).dot(normal) >= 0;
    if (!nearest.inside) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < 3; ++k) {
            bool ignored = false;
            const Vec3 p = nearestOnLine(t[k], t[(k + 1) % 3], centre, ignored);
            if ((p - centre).squaredNorm() >= least) continue;
            least = (p - centre).squaredNorm();
            nearest.point = p;
        }
    }
    nearest.distance = (nearest.point - centre).norm();
    return nearest;
}

/// Where a triangle crosses the plane through a point, across an axle.
std::optional<std::array<Vec3, 2>> cut(const Triangle& t, const Vec3& point, const Vec3& axle) {
    std::array<double, 3> height{};
    for (std::size_t k = 0; k < 3; ++k) height[k] = axle.dot(t[k] - point);
    std::array<Vec3, 2> ends;
    std::size_t count = 0;
    for (std::size_t k = 0; k < 3 && count < 2; ++k) {
        const std::size_t next = (k + 1) % 3;
        if ((height[k] < 0) == (height[next] < 0)) continue;
        ends[count++] = t[k] + height[k] / (height[k] - height[next]) * (t[next] - t[k]);
    }
    return count == 2 ? std::optional(ends) : std::nullopt;
}

/// Drops what lies on the edge of a face that is touched nearer to the centre, and what is found twice. Nearest first.
void dropInner(std::vector<Nearest>& all, double radius) {
    std::ranges::stable_sort(all, {}, &Nearest::distance);
    const double close = kSamePlane * radius;
    std::size_t kept = 0;
    for (const Nearest& n : all) {
        const bool isInner =
            !n.inside && std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), [&](const Nearest& k) {
                const Vec3 way = n.point - k.point;
                return way.norm() < close || (k.inside && std::abs(way.dot(k.normal)) < close);
            });
        if (!isInner) all[kept++] = n;
    }
    all.resize(kept);
}

/// Of a wheel's disc, `along` its axle from the middle, with triangles whose normals are turned by at least `least`, a sine, from the axle.
void discOnTriangles(const WheelPose& wheel, double along, double least, std::span<const Triangle> triangles,
                     std::vector<TreadContact>& contacts) {
    const Vec3 centre = wheel.centre + along * wheel.axle;
    std::vector<Nearest> all;
    for (const Triangle& t : triangles) {
        const auto ends = cut(t, centre, wheel.axle);
        if (!ends) continue;
        const Vec3 normal = normalOf(t);
        if (normal.dot(centre - t[0]) < 0 || normal.cross(wheel.axle).norm() < least) continue;
        Nearest& n = all.emplace_back();
        n.normal = normal;
        n.point = nearestOnLine((*ends)[0], (*ends)[1], centre, n.inside);
        n.distance = (n.point - centre).norm();
        if (n.distance > wheel.radius || n.distance == 0) all.pop_back();
    }
    dropInner(all, wheel.radius);
    for (const Nearest& n : all) {
        const Vec3 down = (centre - n.point) / n.distance;
        TreadContact c;
        c.normal = n.inside ? n.normal : down;
        c.position = centre - wheel.radius * down;
        c.depth = c.normal.dot(n.point - c.position);
        c.rolling = c.normal.cross(wheel.axle).norm() >= kSideHit;
        contacts.push_back(c);
    }
}

} // namespace

void ballOnTriangles(const Vec3& centre, double radius, std::span<const Triangle> triangles, bool solid,
                     std::vector<SurfaceContact>& contacts) {
    std::vector<Nearest> all;
    std::optional<Nearest> behind;
    double front = std::numeric_limits<double>::infinity();
    for (const Triangle& t : triangles) {
        const Vec3 normal = normalOf(t);
        const double above = normal.dot(centre - t[0]);
        const Nearest n = nearestOnTriangle(t, normal, centre);
        if (above > 0) front = std::min(front, n.distance);
        if (above > 0 && n.distance <= radius) all.push_back(n);
        if (above <= 0 && n.inside && (!behind || n.distance < behind->distance)) behind = n;
    }
    if (solid && behind && behind->distance < front) {
        contacts.push_back({centre - radius * behind->normal, behind->normal, radius + behind->distance});
        return;
    }
    dropInner(all, radius);
    for (const Nearest& n : all) {
        const Vec3 normal = n.inside ? n.normal : (centre - n.point) / n.distance;
        contacts.push_back({centre - radius * normal, normal, radius - n.distance});
    }
}

void cylinderOnTriangles(const WheelPose& cylinder, double halfLength, std::span<const Triangle> triangles,
                         std::vector<SurfaceContact>& contacts) {
    const double pieces = std::min(std::ceil(2 * halfLength / cylinder.radius), kMostDiscs - 1);
    std::vector<TreadContact> all;
    for (double i = 0; i <= pieces; ++i)
        discOnTriangles(cylinder, (2 * i / pieces - 1) * halfLength, kFlushSlope, triangles, all);
    contacts.insert(contacts.end(), all.begin(), all.end());
}

void wheelOnTriangles(const WheelPose& wheel, double halfWidth, std::span<const Triangle> triangles,
                      std::vector<TreadContact>& contacts) {
    discOnTriangles(wheel, 0, kSideHit, triangles, contacts);
    for (const double side : {-kRim * halfWidth, kRim * halfWidth}) {
        if (halfWidth == 0) break;
        std::vector<TreadContact> rim;
        discOnTriangles(wheel, side, kFlushSlope, triangles, rim);
        for (const TreadContact& c : rim) {
            const auto same = [&](const TreadContact& k) {
                return k.normal.dot(c.normal) > kSameWay && c.depth < k.depth + kTilt * halfWidth;
            };
            if (std::ranges::none_of(contacts, same)) contacts.push_back(c);
        }
    }
    std::ranges::stable_sort(contacts, std::greater(), &TreadContact::depth);
    std::size_t kept = 0;
    for (const TreadContact& c : contacts) {
        const auto same = [&](const TreadContact& k) { return k.normal.dot(c.normal) > kSameWay; };
        if (kept < kMaxDirections && std::none_of(contacts.begin(), contacts.begin() + static_cast<std::ptrdiff_t>(kept), same))
            contacts[kept++] = c;
    }
    contacts.resize(kept);
}

} // namespace trundle
