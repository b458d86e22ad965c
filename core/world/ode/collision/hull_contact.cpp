// Needs: convex bodies. Assumes: they overlap little. Method: the face plane that the other body enters least is the reference; the
// other's triangles that face it are clipped by all planes of the reference body. Data: both bodies in the world, made per pair.
#include "world/ode/collision/hull_contact.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace trundle {

namespace {

constexpr double kPreferSecond =
    1e-6;                           // m: of two faces as good the second body's is taken, so that it does not change every tick
constexpr double kAsOpposed = 0.02; // cosine: triangles this much less opposed to the reference still touch it

struct ReferenceFace {
    std::size_t face = 0;
    double above = -std::numeric_limits<double>::infinity(); ///< the other's lowest point over the face's plane
};

ReferenceFace bestFace(const FlatBody& body, const FlatBody& other) {
    ReferenceFace best;
    for (std::size_t f = 0; f < body.normals.size(); ++f) {
        double lowest = std::numeric_limits<double>::infinity();
        for (const Vec3& p : other.points) {
            lowest = std::min(lowest, body.normals[f].dot(p) - body.offsets[f]);
            if (lowest <= best.above) break;
        }
        if (lowest > best.above) best = {f, lowest};
    }
    return best;
}

} // namespace

void FlatBody::clear() {
    points.clear();
    triangles.clear();
    normals.clear();
    offsets.clear();
}

void FlatBody::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, const Vec3& normal) {
    triangles.push_back({a, b, c});
    normals.push_back(normal);
    offsets.push_back(normal.dot(points[a]));
}

void FlatBody::setBox(const Vec3& centre, const Mat3& axes, const Vec3& half) {
    clear();
    for (int i = 0; i < 8; ++i)
        points.push_back(centre + axes * half.cwiseProduct(Vec3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
    for (int axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            // The face's corners, round it: its other two axes in cyclic order.
            const std::uint32_t u = 1u << ((axis + 1) % 3), v = 1u << ((axis + 2) % 3), at = side > 0 ? 1u << axis : 0u;
            const Vec3 normal = side * axes.col(axis);
            const std::uint32_t b = side > 0 ? u : v, d = side > 0 ? v : u;
            addTriangle(at, at | b, at | u | v, normal);
            addTriangle(at, at | u | v, at | d, normal);
        }
}

void FlatBody::setCylinder(const Vec3& centre, const Mat3& axes, double radius, double halfLength) {
    constexpr std::uint32_t kSides = 32;
    constexpr double kStep = 2 * std::numbers::pi / kSides;
    const double corner = radius / std::cos(kStep / 2);
    clear();
    for (std::uint32_t i = 0; i < kSides; ++i) // even: below, odd: above
        for (const double z : {-halfLength, halfLength})
            points.push_back(centre + axes * Vec3(corner * std::cos(i * kStep), corner * std::sin(i * kStep), z));
    for (std::uint32_t i = 0; i < kSides; ++i) {
        const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % kSides);
        const Vec3 out = axes * Vec3(std::cos((i + 0.5) * kStep), std::sin((i + 0.5) * kStep), 0);
        addTriangle(a, b, b + 1, out);
        addTriangle(a, b + 1, a + 1, out);
        if (i == 0 || i + 1 == kSides) continue;
        addTriangle(1, a + 1, b + 1, axes.col(2));
        addTriangle(0, b, a, -axes.col(2));
    }
}

/// Sutherland-Hodgman.
void clipPolygon(std::vector<Vec3>& polygon, const Vec3& normal, double offset, std::vector<Vec3>& scratch) {
    scratch.clear();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double da = normal.dot(a) - offset, db = normal.dot(b) - offset;
        if (da <= 0) scratch.push_back(a);
        if ((da < 0 && db > 0) || (da > 0 && db < 0)) scratch.push_back(a + da / (da - db) * (b - a));
    }
    polygon.swap(scratch);
}

void FlatPair::clipFaces(const FlatBody& body, std::size_t reference, const FlatBody& other) {
    const Vec3& normal = body.normals[reference];
    double opposed = 1;
    for (const Vec3& n : other.normals) opposed = std::min(opposed, n.dot(normal));
    for (std::size_t t = 0; t < other.triangles.size(); ++t) {
        if (other.normals[t].dot(normal) > opposed + kAsOpposed) continue;
        m_polygon.clear();
        for (const std::uint32_t corner : other.triangles[t]) m_polygon.push_back(other.points[corner]);
        for (std::size_t f = 0; f < body.normals.size() && !m_polygon.empty(); ++f)
            clipPolygon(m_polygon, body.normals[f], body.offsets[f], m_scratch);
        for (const Vec3& p : m_polygon) touch.contacts.push_back({p, body.offsets[reference] - normal.dot(p)});
    }
}

const FlatTouch& FlatPair::findContacts() {
    touch.contacts.clear();
    const ReferenceFace onSecond = bestFace(second, first), onFirst = bestFace(first, second);
    touch.apart = onSecond.above > 0 || onFirst.above > 0;
    touch.normal = Vec3::UnitZ();
    if (touch.apart) return touch;
    if (onSecond.above >= onFirst.above - kPreferSecond) {
        touch.normal = second.normals[onSecond.face];
        clipFaces(second, onSecond.face, first);
    } else {
        touch.normal = -first.normals[onFirst.face];
        clipFaces(first, onFirst.face, second);
    }
    return touch;
}

} // namespace trundle
