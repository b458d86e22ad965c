// needs: support points of two convex pieces.
// assumes: distances below 100 km; 0.1 micrometre counts as zero.
// method: a piece that moves along a line is clear of the other piece once the line leaves their Minkowski difference (all
//   vectors from a point of one to a point of the other). That exit point is found from far outside with the ray cast of G. van
//   den Bergen, "Ray Casting against General Convex Objects with Application to Continuous Collision Detection" (2004): the point
//   on the ray advances to the plane of the newest support point for as long as that plane separates it from the difference.
// data: up to four support points of the difference; only those spanning the point closest to the ray's point are kept.
#include "scene/queries/clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr double kNear = 1e-7; // m; closer counts as touching
constexpr int kMaxIterations = 100;
constexpr std::size_t kMaxTriangles = 200000;
const double kEndless = std::numeric_limits<double>::infinity();

/// Up to four points, reduced to those that span the point closest to the origin (as in GJK).
class Simplex {
public:
    void add(const Vec3& point) {
        m_points[std::size_t(m_count)] = point;
        m_count = std::min(m_count + 1, 4);
    }
    void shift(const Vec3& by) {
        for (int i = 0; i < m_count; ++i) m_points[std::size_t(i)] += by;
    }
    [[nodiscard]] bool isFull() const { return m_count == 4; }
    [[nodiscard]] bool has(const Vec3& point) const {
        return std::any_of(m_points.begin(), m_points.begin() + m_count,
                           [&](const Vec3& p) { return (p - point).squaredNorm() < 1e-24; });
    }

    /// The point of the hull closest to the origin; points that do not contribute to it are dropped.
    Vec3 nearest() {
        double best = kEndless;
        Vec3 nearest = Vec3::Zero();
        int kept = 0;
        for (int subset = 1; subset < 1 << m_count; ++subset) { // at most 15: all faces, edges and corners
            Vec3 point;
            if (!nearestIn(subset, point)) continue;
            const double distance = point.squaredNorm();
            if (distance < best - 1e-20) best = distance, nearest = point, kept = subset;
        }
        int count = 0;
        for (int i = 0; i < m_count; ++i)
            if (kept >> i & 1) m_points[std::size_t(count++)] = m_points[std::size_t(i)];
        m_count = count;
        return nearest;
    }

private:
    /// The foot of the perpendicular from the origin to the span of `subset`, if it lies inside that subset's hull.
    bool nearestIn(int subset, Vec3& point) const {
        std::array<Vec3, 4> p;
        int n = 0;
        for (int i = 0; i < m_count; ++i)
            if (subset >> i & 1) p[std::size_t(n++)] = m_points[std::size_t(i)];
        Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> edges(3, n - 1);
        for (int i = 1; i < n; ++i) edges.col(i - 1) = p[std::size_t(i)] - p[0];
        point = p[0];
        if (n == 1) return true;
        const auto solver = (edges.transpose() * edges).eval().fullPivLu();
        if (!solver.isInvertible()) return false; // degenerate; a smaller subset has the same span
        const Eigen::VectorXd share = solver.solve(-(edges.transpose() * p[0]));
        if (share.minCoeff() < -1e-12 || share.sum() > 1 + 1e-12) return false;
        point = p[0] + edges * share;
        return true;
    }

    std::array<Vec3, 4> m_points;
    int m_count = 0;
};

/// Distance (m) along the ray to where it enters a convex set; nullopt if it misses.
template <class Support> std::optional<double> enters(const Vec3& from, const Vec3& along, const Support& support) {
    double way = 0;
    Vec3 at = from, towards = from - support(-from.normalized());
    Simplex simplex; // of the ray's point minus points of the set
    for (int i = 0; i < kMaxIterations && towards.norm() > kNear; ++i) {
        const Vec3 p = support(towards);
        Vec3 w = at - p;
        const bool isKnown = simplex.has(w);
        bool goesOn = false;
        if (const double ahead = towards.dot(w); ahead > 0) {
            const double speed = towards.dot(along);
            if (speed >= -1e-12 * towards.norm()) return std::nullopt;
            const double by = -ahead / speed;
            way += by;
            at += by * along;
            simplex.shift(by * along);
            w = at - p;
            goesOn = by > 0;
        }
        if ((isKnown && !goesOn) || (!isKnown && simplex.isFull())) break; // no closer point can be found
        if (!isKnown) simplex.add(w);
        towards = simplex.nearest();
    }
    return way;
}

/// Candidate directions for the penetration depth; the first six are the axes.
std::vector<Vec3> manyDirections() {
    std::vector<Vec3> all;
    for (int k = 0; k < 3; ++k)
        for (const double sign : {1.0, -1.0}) all.push_back(sign * Vec3::Unit(k));
    for (int i = 1; i < 16; ++i) {
        const double angle = 2 * M_PI * i / 16;
        if (i % 4) all.emplace_back(std::cos(angle), std::sin(angle), 0);
    }
    return all;
}

/// Calls `add` with the corners of each triangle.
template <class Add> void forTriangles(const TriangleMesh& mesh, const Add& add) {
    const auto point = [&](std::uint32_t i) { return Vec3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]); };
    for (const auto& t : mesh.triangles)
        if (std::max({t[0], t[1], t[2]}) < mesh.points.size()) add(point(t[0]), point(t[1]), point(t[2]));
}

template <class Add> void forTriangles(const HeightMap& map, const Vec3& size, const Add& add) {
    if (map.columns < 2 || map.rows < 2 || map.heights.size() < std::size_t(map.columns) * map.rows) return;
    const auto point = [&](std::uint32_t column, std::uint32_t row) {
        return Vec3(size.x() * (double(column) / (map.columns - 1) - 0.5), size.y() * (0.5 - double(row) / (map.rows - 1)),
                    size.z() * double(map.heights[std::size_t(row) * map.columns + column]));
    };
    for (std::uint32_t row = 0; row + 1 < map.rows; ++row)
        for (std::uint32_t column = 0; column + 1 < map.columns; ++column) {
            add(point(column, row), point(column, row + 1), point(column + 1, row));
            add(point(column + 1, row), point(column, row + 1), point(column + 1, row + 1));
        }
}

} // namespace

std::vector<ConvexPiece> ConvexPiece::of(const GeomSpec& geom, const Pose& owner, const Bounds& about) {
    if (isPlaceholder(geom)) return {}; // placeholders do not collide
    const bool isMesh = geom.shape == GeomShape::Mesh || geom.shape == GeomShape::Convex;
    if (geom.shape == GeomShape::Heightfield || (isMesh && !geom.collideAsHull)) return ofTriangles(geom, owner, about);
    std::vector<ConvexPiece> pieces(1);
    ConvexPiece& piece = pieces.front();
    piece.m_pose = owner * geom.pose;
    piece.takeShape(geom);
    if (!piece.isHalfSpace()) piece.m_bounds = boundsOf(geom, owner);
    return pieces;
}

/// The points and radii of a geom that is one convex piece.
void ConvexPiece::takeShape(const GeomSpec& geom) {
    const Vec3 half = 0.5 * geom.size, end(0, 0, 0.5 * geom.length);
    switch (geom.shape) {
    case GeomShape::Box:
        for (int i = 0; i < 8; ++i) m_points.push_back(half.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
        break;
    case GeomShape::Sphere:
        m_points = {Vec3::Zero()};
        m_grown = geom.radius;
        break;
    case GeomShape::Capsule:
        m_points = {end, -end};
        m_grown = geom.radius;
        break;
    case GeomShape::Cylinder:
        m_radius = geom.radius;
        m_half = 0.5 * geom.length;
        break;
    case GeomShape::Plane: m_normal = m_pose.rotation * Vec3::UnitZ(); break;
    case GeomShape::Convex:
    case GeomShape::Mesh:
        for (const auto& p : (geom.hull ? *geom.hull : *geom.mesh).points) m_points.emplace_back(p[0], p[1], p[2]);
        break;
    case GeomShape::Heightfield: break; // triangles
    }
}

/// One piece for each triangle of a mesh or height map near `about`.
std::vector<ConvexPiece> ConvexPiece::ofTriangles(const GeomSpec& geom, const Pose& owner, const Bounds& about) {
    std::vector<ConvexPiece> pieces;
    const Pose pose = owner * geom.pose;
    const auto add = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        if (pieces.size() >= kMaxTriangles) return;
        ConvexPiece one;
        one.m_pose = pose;
        one.m_points = {a, b, c};
        for (const Vec3& p : one.m_points) one.m_bounds.add(pose * p);
        const bool apart =
            (one.m_bounds.low.array() > about.high.array()).any() || (one.m_bounds.high.array() < about.low.array()).any();
        if (!apart) pieces.push_back(std::move(one));
    };
    if (geom.shape == GeomShape::Heightfield) forTriangles(*geom.heightMap, geom.size, add);
    else forTriangles(*geom.mesh, add);
    return pieces;
}

Vec3 ConvexPiece::support(const Vec3& direction) const {
    const Vec3 d = m_pose.rotation.conjugate() * direction;
    Vec3 best = Vec3::Zero();
    if (m_points.empty()) { // a cylinder
        const double across = d.head<2>().norm();
        if (across > 1e-15) best.head<2>() = m_radius / across * d.head<2>();
        best.z() = d.z() < 0 ? -m_half : m_half;
    } else {
        best = *std::max_element(m_points.begin(), m_points.end(),
                                 [&](const Vec3& a, const Vec3& b) { return a.dot(d) < b.dot(d); });
        if (m_grown > 0 && d.norm() > 0) best += m_grown * d.normalized();
    }
    return m_pose * best;
}

void ConvexPiece::move(const Vec3& by) {
    m_pose.position += by;
    if (m_bounds.empty()) return;
    m_bounds.low += by;
    m_bounds.high += by;
}

double ConvexPiece::exitDistance(const ConvexPiece& fixed, const Vec3& direction) const {
    if (fixed.isHalfSpace()) {
        const double below = fixed.m_normal.dot(fixed.m_pose.position - support(-fixed.m_normal));
        if (below <= 0) return 0;
        const double speed = fixed.m_normal.dot(direction);
        return speed > 1e-9 ? below / speed : kEndless;
    }
    // Displaced by t, the two intersect if and only if t is in the Minkowski difference `fixed` - this.
    const auto difference = [&](const Vec3& d) { return Vec3(fixed.support(d) - support(-d)); };
    const double far = std::max(0.0, difference(direction).dot(direction)) + 1;
    const std::optional<double> way = enters(far * direction, -direction, difference);
    return way ? std::max(0.0, far - *way) : 0;
}

bool ConvexPiece::isInside(const ConvexPiece& fixed, double depth) const {
    if (fixed.isHalfSpace()) return fixed.m_normal.dot(fixed.m_pose.position - support(-fixed.m_normal)) > depth;
    if ((m_bounds.low.array() >= fixed.m_bounds.high.array() - depth).any()) return false;
    if ((m_bounds.high.array() <= fixed.m_bounds.low.array() + depth).any()) return false;
    // Disjoint convex pieces have a separating plane; the closest point of their difference gives its normal.
    const auto difference = [&](const Vec3& d) { return Vec3(fixed.support(d) - support(-d)); };
    Simplex simplex;
    Vec3 nearest = difference(Vec3::UnitX());
    simplex.add(nearest);
    for (int i = 0; i < kMaxIterations; ++i) {
        nearest = simplex.nearest();
        if (nearest.norm() < kNear || simplex.isFull()) break;
        const Vec3 p = difference(-nearest);
        if (nearest.dot(p) > 0) return false; // separating plane found
        if (simplex.has(p)) break;
        simplex.add(p);
    }
    static const std::vector<Vec3> kWays = manyDirections();
    return std::all_of(kWays.begin(), kWays.end(), [&](const Vec3& way) { return exitDistance(fixed, way) > depth; });
}

} // namespace trundle
