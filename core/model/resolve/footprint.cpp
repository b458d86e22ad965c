#include "model/resolve/footprint.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace trundle {

namespace {

using Vec2 = Eigen::Vector2d;
constexpr std::size_t kMaxTriangles = 20000; ///< a larger mesh is replaced by its outline

double cross(const Vec2& a, const Vec2& b, const Vec2& c) { return (b - a).x() * (c - a).y() - (b - a).y() * (c - a).x(); }

/// Convex hull by Andrew's monotone chain.
std::vector<Vec2> hull(std::vector<Vec2> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec2& a, const Vec2& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 3) return points;
    std::vector<Vec2> chain(points.size() * 2);
    std::size_t k = 0;
    for (const Vec2& p : points) {
        while (k >= 2 && cross(chain[k - 2], chain[k - 1], p) <= 0) --k;
        chain[k++] = p;
    }
    const std::size_t lower = k + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) {
        while (k >= lower && cross(chain[k - 2], chain[k - 1], points[i]) <= 0) --k;
        chain[k++] = points[i];
    }
    chain.resize(k - 1);
    return chain;
}

/// Points of a shape in its own frame; the shape is their convex hull grown by the radius `grown` (m).
std::vector<Vec3> outline(const GeomSpec& geom, double& grown) {
    std::vector<Vec3> points;
    switch (geom.shape) {
    case GeomShape::Box:
        for (int i = 0; i < 8; ++i)
            points.push_back(0.5 * geom.size.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        break;
    case GeomShape::Sphere:
        points.push_back(Vec3::Zero());
        grown = geom.radius;
        break;
    case GeomShape::Capsule:
        points = {Vec3(0, 0, geom.length / 2), Vec3(0, 0, -geom.length / 2)};
        grown = geom.radius;
        break;
    case GeomShape::Cylinder: {
        constexpr int kSides = 16;
        const double r = geom.radius / std::cos(std::numbers::pi / kSides); // polygon around the circle, not inside it
        for (int i = 0; i < kSides; ++i) {
            const double a = 2 * std::numbers::pi * i / kSides;
            for (double z : {-0.5, 0.5}) points.emplace_back(r * std::cos(a), r * std::sin(a), z * geom.length);
        }
        break;
    }
    default:
        if (geom.mesh)
            for (const auto& p : geom.mesh->points) points.emplace_back(p[0], p[1], p[2]);
        break;
    }
    return points;
}

Footprint footprint(const std::vector<Vec3>& points, double grown) {
    Footprint f{{}, grown, points[0].z(), points[0].z()};
    std::vector<Vec2> flat;
    for (const Vec3& p : points) {
        flat.emplace_back(p.x(), p.y());
        f.low = std::min(f.low, p.z());
        f.high = std::max(f.high, p.z());
    }
    f.low -= grown;
    f.high += grown;
    f.corners = hull(std::move(flat));
    return f;
}

double distanceToEdge(const Vec2& p, const Vec2& a, const Vec2& b) {
    const Vec2 along = b - a;
    const double length = along.squaredNorm();
    const double t = length > 0 ? std::clamp((p - a).dot(along) / length, 0.0, 1.0) : 0;
    return (p - (a + t * along)).norm();
}

} // namespace

bool Footprint::meets(const Vec2& centre, double radius, double discLow, double discHigh) const {
    constexpr double kTouch = 1e-3; // m; resting on a floor is not an overlap
    if (high <= discLow + kTouch || low >= discHigh) return false;
    bool inside = corners.size() >= 3;
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i], &b = corners[(i + 1) % corners.size()];
        if (cross(a, b, centre) < 0) inside = false;
        nearest = std::min(nearest, distanceToEdge(centre, a, b));
    }
    return inside || nearest < radius + grown;
}

std::vector<Footprint> footprintsOf(const GeomSpec& geom, const Pose& pose) {
    std::vector<Footprint> all;
    if (!geom.collide || geom.shape == GeomShape::Plane || geom.shape == GeomShape::Heightfield) return all;
    const Pose at = pose * geom.pose;
    if (geom.shape == GeomShape::Mesh && geom.mesh && !geom.collideAsHull && geom.mesh->triangles.size() <= kMaxTriangles) {
        for (const auto& t : geom.mesh->triangles) { // a hollow mesh, such as an arena, has free space inside
            std::vector<Vec3> points;
            for (std::uint32_t i : t)
                points.push_back(at * Vec3(geom.mesh->points[i][0], geom.mesh->points[i][1], geom.mesh->points[i][2]));
            all.push_back(footprint(points, 0));
        }
        return all;
    }
    double grown = 0;
    std::vector<Vec3> points = outline(geom, grown);
    if (points.empty()) return all;
    for (Vec3& p : points) p = at * p;
    all.push_back(footprint(points, grown));
    return all;
}

namespace {

void add(RobotDisc& disc, const std::vector<GeomSpec>& geoms, const Pose& pose) {
    for (const GeomSpec& geom : geoms) {
        if (!geom.collide || geom.shape == GeomShape::Plane || geom.shape == GeomShape::Heightfield) continue;
        double grown = 0;
        for (const Vec3& p : outline(geom, grown)) {
            const Vec3 q = pose * (geom.pose * p);
            disc.radius = std::max(disc.radius, std::hypot(q.x(), q.y()) + grown);
            disc.low = std::min(disc.low, q.z() - grown);
            disc.high = std::max(disc.high, q.z() + grown);
        }
    }
}

} // namespace

RobotDisc discOf(const RobotConfigSpec& config) { return discOf({}, &config); }

RobotDisc discOf(const std::vector<GeomSpec>& geoms, const RobotConfigSpec* moving) {
    RobotDisc disc{0, std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    add(disc, geoms, Pose{});
    if (moving)
        for (const BodySpec& body : moving->bodies) add(disc, body.geoms, body.pose);
    if (disc.low > disc.high) disc.low = disc.high = 0;
    return disc;
}

} // namespace trundle
