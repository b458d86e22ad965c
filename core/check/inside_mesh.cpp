// Method: a ray from the point counts +1 for each triangle that it leaves through and -1 for each that it enters through. The sum
// is 1 for a point inside. Rays in three directions must agree, so that an open surface encloses nothing.

#include "check/inside_mesh.h"

#include <array>

namespace trundle {

namespace {

/// +1 where the ray leaves through the triangle, -1 where it enters, 0 where it misses (Möller and Trumbore 1997).
int crossing(const Vec3& origin, const Vec3& direction, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a, ac = c - a, p = direction.cross(ac);
    const double determinant = ab.dot(p);
    if (determinant == 0) return 0;
    const Vec3 from = origin - a;
    const double u = from.dot(p) / determinant;
    if (u < 0 || u > 1) return 0;
    const Vec3 q = from.cross(ab);
    const double v = direction.dot(q) / determinant;
    if (v < 0 || u + v > 1 || ac.dot(q) / determinant <= 0) return 0;
    return determinant < 0 ? 1 : -1;
}

} // namespace

bool isInside(const TriangleMesh& mesh, const Vec3& point) {
    const std::array<Vec3, 3> directions{Vec3(0.913, 0.271, 0.304), Vec3(-0.352, 0.877, -0.327), Vec3(0.219, -0.403, 0.889)};
    const auto corner = [&](std::uint32_t i) { return Vec3(mesh.points[i][0], mesh.points[i][1], mesh.points[i][2]); };
    for (const Vec3& direction : directions) {
        int winding = 0;
        for (const auto& t : mesh.triangles) winding += crossing(point, direction, corner(t[0]), corner(t[1]), corner(t[2]));
        if (winding < 1) return false;
    }
    return true;
}

} // namespace trundle
