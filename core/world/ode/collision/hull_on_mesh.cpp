// Needs: triangles near the body. Method: for each triangle, the direction of least overlap is either its own normal or that of a
//   face of the body. The triangle's normal is preferred, and coplanar neighbours of such a triangle use it too, so that the
//   seams of a floor do not act as edges. Then the faces of one are clipped by the sides of the other. Data: everything in world
//   coordinates, built per pair.
#include "world/ode/collision/hull_on_mesh.h"

#include <algorithm>
#include <limits>

namespace trundle {

namespace {

constexpr double kPreferSurface = 2e-3; // m, by which a body's face must be better than the triangle's own normal
constexpr double kSameNormal = 1e-6, kSameOffset = 1e-5; // 1 - cosine, m: limits for coplanar triangles
constexpr double kFaceOpposed = 0.02;                    // cosine; faces less opposed to the triangle by up to this also touch it

/// A triangle that the body penetrates.
struct Overlap {
    const Triangle* triangle = nullptr;
    Vec3 normal = Vec3::UnitZ(); ///< on the side of the body
    double offset = 0, depth = 0;
    std::size_t face = 0; ///< the body's face with the least penetration
    bool onSurface = true;
};

bool overlaps(const FlatBody& body, const Triangle& t, Overlap& o) {
    o.triangle = &t;
    o.normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
    o.offset = o.normal.dot(t[0]);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& p : body.points) {
        const double above = o.normal.dot(p) - o.offset;
        low = std::min(low, above);
        high = std::max(high, above);
    }
    if (low >= 0 || high <= 0) return false;
    o.depth = std::min(-low, high);
    if (high < -low) { // the body is mostly on the back side
        o.normal = -o.normal;
        o.offset = -o.offset;
    }
    double least = -std::numeric_limits<double>::infinity();
    for (std::size_t f = 0; f < body.normals.size(); ++f) {
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3& p : t) lowest = std::min(lowest, body.normals[f].dot(p) - body.offsets[f]);
        if (lowest >= 0) return false;
        if (lowest <= least) continue;
        least = lowest;
        o.face = f;
    }
    o.onSurface = o.depth <= -least + kPreferSurface;
    return true;
}

bool inOnePlane(const Overlap& a, const Overlap& b) {
    return a.normal.dot(b.normal) > 1 - kSameNormal && std::abs(a.offset - b.offset) < kSameOffset;
}

/// Contacts from the body's faces opposed to the triangle, clipped by its three sides.
void contactsWithTriangle(const FlatBody& body, const Overlap& o, std::vector<SurfaceContact>& contacts) {
    double opposed = 1;
    for (const Vec3& n : body.normals) opposed = std::min(opposed, n.dot(o.normal));
    std::vector<Vec3> polygon, scratch;
    const Triangle& t = *o.triangle;
    const double turn = (t[1] - t[0]).cross(t[2] - t[0]).dot(o.normal) > 0 ? 1 : -1;
    for (std::size_t f = 0; f < body.triangles.size(); ++f) {
        if (body.normals[f].dot(o.normal) > opposed + kFaceOpposed) continue;
        polygon.clear();
        for (const std::uint32_t corner : body.triangles[f]) polygon.push_back(body.points[corner]);
        for (std::size_t side = 0; side < 3 && !polygon.empty(); ++side) {
            const Vec3 out = turn * (t[(side + 1) % 3] - t[side]).cross(o.normal);
            clipPolygon(polygon, out, out.dot(t[side]), scratch);
        }
        if (!polygon.empty()) clipPolygon(polygon, o.normal, o.offset, scratch);
        for (const Vec3& p : polygon) contacts.push_back({p, o.normal, o.offset - o.normal.dot(p)});
    }
}

/// Contacts from the triangle, clipped by the whole body.
void contactsWithBody(const FlatBody& body, const Overlap& o, std::vector<SurfaceContact>& contacts) {
    std::vector<Vec3> polygon(o.triangle->begin(), o.triangle->end()), scratch;
    for (std::size_t f = 0; f < body.normals.size() && !polygon.empty(); ++f)
        clipPolygon(polygon, body.normals[f], body.offsets[f], scratch);
    for (const Vec3& p : polygon)
        contacts.push_back({p, -body.normals[o.face], body.offsets[o.face] - body.normals[o.face].dot(p)});
}

} // namespace

std::vector<SurfaceContact> contactsOnSurface(const FlatBody& body, std::span<const Triangle> triangles) {
    std::vector<Overlap> overlapping;
    Overlap overlap;
    for (const Triangle& t : triangles)
        if (overlaps(body, t, overlap)) overlapping.push_back(overlap);
    std::vector<const Overlap*> planes; // one per plane
    for (const Overlap& o : overlapping) {
        const bool known = std::ranges::any_of(planes, [&](const Overlap* p) { return inOnePlane(*p, o); });
        if (o.onSurface && !known) planes.push_back(&o);
    }
    std::vector<SurfaceContact> contacts;
    for (const Overlap& o : overlapping) {
        const bool lies = o.onSurface || std::ranges::any_of(planes, [&](const Overlap* p) { return inOnePlane(*p, o); });
        if (lies) contactsWithTriangle(body, o, contacts);
        else contactsWithBody(body, o, contacts);
    }
    return contacts;
}

} // namespace trundle
