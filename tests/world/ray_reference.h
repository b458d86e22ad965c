#pragma once
// What a ray hits, by other formulas than the program's: the nearest point t >= 0 of the ray on a surface of the geom, each face, side and
// cap by itself. A ray that starts inside a solid meets its surface from within.
#include <algorithm>
#include <array>
#include <vector>

#include "world/fixtures.h"
#include "world/rays/ray_query.h"

namespace fixture {

inline constexpr double kMiss = 1e300;

class RayReference {
public:
    Vec3 origin, direction; ///< in the geom's frame; a unit vector
    double best = kMiss;

    void keep(double t) {
        if (t >= 0 && t < best) best = t;
    }
    [[nodiscard]] Vec3 at(double t) const { return origin + t * direction; }

    /// The face x[axis] = place, where the other two coordinates are within `half`.
    void face(int axis, double place, const Vec3& half) {
        if (direction[axis] == 0) return;
        const double t = (place - origin[axis]) / direction[axis];
        const Vec3 p = at(t);
        bool inside = true;
        for (int k = 0; k < 3; ++k) inside = inside && (k == axis || std::abs(p[k]) <= half[k]);
        if (inside) keep(t);
    }
    /// Both roots of |p + t d|^2 = r^2 with only the coordinates up to `dimensions`, where `on` says so. Distances from the middle of the
    /// chord, by projection.
    template <class On> void round(const Vec3& centre, int dimensions, double r, On on) {
        Vec3 d = direction, p = centre - origin;
        if (dimensions == 2) d.z() = p.z() = 0;
        const double length = d.norm();
        if (length < 1e-14) return;
        const double middle = p.dot(d) / length, miss = (p - middle / length * d).norm();
        if (miss > r) return;
        const double half = std::sqrt((r - miss) * (r + miss));
        for (const double s : {middle - half, middle + half})
            if (on(at(s / length))) keep(s / length);
    }
    void triangle(const Vec3& a, const Vec3& b, const Vec3& c) { // by its plane, then the three sides
        const Vec3 normal = (b - a).cross(c - a);
        const double slope = normal.dot(direction);
        if (slope == 0) return;
        const double t = normal.dot(a - origin) / slope;
        const Vec3 p = at(t);
        const auto side = [&](const Vec3& u, const Vec3& v) { return (v - u).cross(p - u).dot(normal) / normal.squaredNorm(); };
        if (side(a, b) >= -1e-12 && side(b, c) >= -1e-12 && side(c, a) >= -1e-12) keep(t);
    }
};

/// Distance along the ray of a geom at `pose`; kMiss if it is not hit within the range.
inline double referenceHit(const GeomSpec& geom, const Pose& pose, const SingleRay& ray) {
    const Pose inverse = pose.inverse();
    RayReference r;
    r.origin = inverse * ray.origin;
    r.direction = inverse.rotation * ray.direction;
    const auto all = [](const Vec3&) { return true; };
    const double h = geom.length / 2;
    const auto withinEnds = [&](const Vec3& p) { return std::abs(p.z()) <= h; };
    switch (geom.shape) {
    case GeomShape::Box:
        for (int k = 0; k < 3; ++k)
            for (const double s : {-0.5, 0.5}) r.face(k, s * geom.size[k], geom.size / 2);
        break;
    case GeomShape::Sphere: r.round(Vec3::Zero(), 3, geom.radius, all); break;
    case GeomShape::Cylinder:
        r.round(Vec3::Zero(), 2, geom.radius, withinEnds);
        for (const double end : {-h, h})
            if (const double t = (end - r.origin.z()) / r.direction.z(); r.at(t).head<2>().norm() <= geom.radius) r.keep(t);
        break;
    case GeomShape::Capsule:
        r.round(Vec3::Zero(), 2, geom.radius, withinEnds);
        r.round({0, 0, h}, 3, geom.radius, [&](const Vec3& p) { return p.z() >= h; });
        r.round({0, 0, -h}, 3, geom.radius, [&](const Vec3& p) { return p.z() <= -h; });
        break;
    case GeomShape::Plane:
        if (r.direction.z() != 0) r.keep(-r.origin.z() / r.direction.z());
        break;
    case GeomShape::Mesh:
    case GeomShape::Convex: {
        const TriangleMesh& mesh = geom.hull ? *geom.hull : *geom.mesh;
        const auto corner = [&](std::uint32_t i) { return Vec3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]); };
        for (const auto& t : mesh.triangles) r.triangle(corner(t[0]), corner(t[1]), corner(t[2]));
        break;
    }
    case GeomShape::Heightfield: { // first row at +y; each cell cut from its +x+y corner's neighbours
        const HeightMap& m = *geom.heightMap;
        const auto point = [&](std::uint32_t i, std::uint32_t k) {
            return Vec3((i / (m.columns - 1.) - 0.5) * geom.size.x(), (0.5 - k / (m.rows - 1.)) * geom.size.y(),
                        geom.size.z() * m.heights[k * m.columns + i]);
        };
        for (std::uint32_t k = 0; k + 1 < m.rows; ++k)
            for (std::uint32_t i = 0; i + 1 < m.columns; ++i) {
                r.triangle(point(i, k), point(i + 1, k), point(i, k + 1));
                r.triangle(point(i + 1, k + 1), point(i, k + 1), point(i + 1, k));
            }
    }
    }
    return r.best <= ray.range ? r.best : kMiss;
}

/// Random numbers of a test: the same in every run.
class RayRandom {
public:
    explicit RayRandom(std::uint64_t seed) : m_state(seed * 0x9e3779b97f4a7c15u + 1) {}
    double operator()(double low, double high) {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 7;
        m_state ^= m_state << 17;
        return low + (high - low) * static_cast<double>(m_state >> 11) * 0x1p-53;
    }
    Vec3 vector(double size) { return {(*this)(-size, size), (*this)(-size, size), (*this)(-size, size)}; }
    Quat rotation() {
        for (;;) {
            const Eigen::Vector4d q((*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1));
            if (q.squaredNorm() < 1 && q.squaredNorm() > 0.01) return Quat(q[0], q[1], q[2], q[3]).normalized();
        }
    }

private:
    std::uint64_t m_state;
};

inline SingleRay beamOf(const RayFan& fan, std::size_t at) {
    const double bearing = fan.firstBearing + static_cast<double>(at % fan.count) * fan.bearingStep,
                 up = fan.elevations[at / fan.count];
    const Vec3 local(std::cos(up) * std::cos(bearing), std::cos(up) * std::sin(bearing), std::sin(up));
    return {fan.origin, fan.axes * local, fan.range};
}

/// Results with room for them.
struct RayBuffers {
    std::vector<double> distances, normals;
    std::vector<std::uint32_t> geoms;
    explicit RayBuffers(std::size_t count) : distances(count), normals(3 * count), geoms(count) {}
    RayHits hits() { return {distances.data(), geoms.data(), normals.data()}; }
    bool operator==(const RayBuffers&) const = default; // no NaN in them, no -0 that matters
};

} // namespace fixture
