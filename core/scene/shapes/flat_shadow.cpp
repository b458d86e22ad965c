#include "scene/shapes/flat_shadow.h"

#include <algorithm>
#include <numbers>

#include "base/mesh_appearance.h"

namespace trundle {
namespace {

using Eigen::Vector2d;

constexpr double kInPlane = 0.003; // m: so far below a plane a solid may be as if it stood on it
constexpr int kMostSegments = 96, kMeshSegments = 18;

double cross(const Vector2d& a, const Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// How far a solid reaches along a direction from its centre.
double reachOf(const ShadowSolid& solid, const Mat3& turn, const Vec3& direction) {
    const Vec3 own = turn.transpose() * direction;
    double reach = 0;
    for (const Vec3& half : solid.halves) reach += std::abs(own.dot(half));
    if (!solid.disc) return reach + solid.radius;
    return reach + std::hypot(own.dot((*solid.disc)[0]), own.dot((*solid.disc)[1]));
}

/// The convex hull, counter-clockwise (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions", 1979).
void makeHull(std::vector<Vector2d>& points) {
    const auto before = [](const Vector2d& a, const Vector2d& b) { return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y()); };
    std::sort(points.begin(), points.end(), before);
    std::vector<Vector2d> hull;
    const auto pass = [&](auto first, auto last) {
        const std::size_t start = hull.size();
        for (; first != last; ++first) {
            while (hull.size() >= start + 2 && cross(hull.back() - hull[hull.size() - 2], *first - hull.back()) <= 0)
                hull.pop_back();
            hull.push_back(*first);
        }
        if (!hull.empty()) hull.pop_back(); // it is the first of the other pass
    };
    pass(points.begin(), points.end());
    pass(points.rbegin(), points.rend());
    points = std::move(hull);
}

} // namespace

std::optional<ShadowSolid> shadowSolidOf(const GeomSpec& geom, std::uint32_t index) {
    ShadowSolid solid;
    solid.geom = index;
    solid.centre = geom.pose.position;
    const Mat3 turn = geom.pose.rotation.toRotationMatrix();
    switch (geom.shape) {
    case GeomShape::Box:
        for (int i = 0; i < 3; ++i) solid.halves[std::size_t(i)] = 0.5 * geom.size[i] * turn.col(i);
        break;
    case GeomShape::Cylinder: solid.disc = {geom.radius * turn.col(0), geom.radius * turn.col(1)}; [[fallthrough]];
    case GeomShape::Capsule: solid.halves[0] = 0.5 * geom.length * turn.col(2); [[fallthrough]];
    case GeomShape::Sphere: solid.radius = geom.radius; break;
    case GeomShape::Convex:
        if (isPlaceholder(geom) || hasOwnAppearance(geom)) return std::nullopt;
        solid.isHull = true;
        break;
    default: return std::nullopt;
    }
    ShapeMesh mesh = bareShapeOf(geom, {kMeshSegments, false});
    if (mesh.indices.empty()) return std::nullopt; // cannot be drawn
    for (Eigen::Vector3f& point : mesh.points) point = (geom.pose * Vec3(point.cast<double>())).cast<float>();
    solid.mesh = std::make_shared<const ShapeMesh>(std::move(mesh));
    return solid;
}

ShadowPlane::ShadowPlane(const Pose& frame, const Vec3& light)
    : m_origin(frame.position), m_normal(frame.rotation * Vec3::UnitZ()) {
    const Mat3 axes = frame.rotation.toRotationMatrix();
    const Vec3 way = light.normalized();
    const double up = m_normal.dot(way);
    m_onto = axes.leftCols<2>().transpose() * (Mat3::Identity() - way * m_normal.transpose() / up);
    const Vec3 side = way.unitOrthogonal();
    m_ball = {m_onto * side, m_onto * way.cross(side)};
    m_stretch = 1 / up;
}

void ShadowPlane::cast(const ShadowSolid& solid, const Frame& body, double pixelsPerMetre, Outline& outline) {
    outline.clear();
    if (solid.isHull) return castMesh(*solid.mesh, body, outline);
    const Vec3 centre = body.position + body.turn * solid.centre - m_origin;
    const double height = m_normal.dot(centre), reach = reachOf(solid, body.turn, m_normal);
    if (height + reach < -kInPlane) return;
    if (height - reach < -kInPlane) return castMesh(*solid.mesh, body, outline);
    castSum(solid, body.turn, centre, pixelsPerMetre, outline);
}

/// Each edge belongs to a pair of opposite ones, as all solids are symmetric about their centre: the one that goes up is kept.
void ShadowPlane::addEdge(const Vector2d& edge) {
    if (edge.y() < 0 || (edge.y() == 0 && edge.x() < 0)) m_edges.push_back(-edge);
    else if (edge != Vector2d::Zero()) m_edges.push_back(edge);
}

/// The outline of a sum has the edges of all parts, in the order of their directions.
void ShadowPlane::castSum(const ShadowSolid& solid, const Mat3& turn, const Vec3& centre, double pixelsPerMetre,
                          Outline& outline) {
    m_edges.clear();
    for (const Vec3& half : solid.halves)
        if (half != Vec3::Zero()) addEdge(2 * (m_onto * (turn * half)));
    if (solid.radius > 0) {
        const Vector2d a = solid.disc ? Vector2d(m_onto * (turn * (*solid.disc)[0])) : Vector2d(solid.radius * m_ball[0]);
        const Vector2d b = solid.disc ? Vector2d(m_onto * (turn * (*solid.disc)[1])) : Vector2d(solid.radius * m_ball[1]);
        const int segments = segmentsFor(solid.radius * m_stretch, {kMostSegments, false, pixelsPerMetre});
        Vector2d last = a;
        for (int i = 1; i <= segments / 2; ++i) {
            const double angle = 2 * std::numbers::pi * i / segments;
            const Vector2d next = std::cos(angle) * a + std::sin(angle) * b;
            addEdge(next - last);
            last = next;
        }
    }
    std::sort(m_edges.begin(), m_edges.end(), [](const Vector2d& a, const Vector2d& b) { return cross(a, b) > 0; });
    Vector2d at = m_onto * centre;
    for (const Vector2d& edge : m_edges) at -= 0.5 * edge;
    for (const double sign : {1.0, -1.0}) {
        for (const Vector2d& edge : m_edges) {
            outline.push_back(at);
            at += sign * edge;
        }
    }
}

void ShadowPlane::castMesh(const ShapeMesh& mesh, const Frame& body, Outline& outline) {
    m_points.clear();
    for (const Eigen::Vector3f& point : mesh.points)
        m_points.push_back(body.position + body.turn * point.cast<double>() - m_origin);
    const auto above = [&](const Vec3& point) { return m_normal.dot(point) + kInPlane; };
    for (const Vec3& point : m_points)
        if (above(point) >= 0) outline.push_back(m_onto * point);
    if (outline.size() == m_points.size()) return makeHull(outline);
    for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
        const std::size_t corner = i % 3, next = corner == 2 ? i - 2 : i + 1;
        const Vec3 &from = m_points[mesh.indices[i]], &to = m_points[mesh.indices[next]];
        const double high = above(from), low = above(to);
        if (high >= 0 && low < 0) outline.push_back(m_onto * (from + high / (high - low) * (to - from)));
    }
    makeHull(outline);
}

} // namespace trundle
