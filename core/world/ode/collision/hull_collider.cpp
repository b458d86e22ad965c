#include "world/ode/collision/hull_collider.h"

#include <algorithm>
#include <cmath>

#include "world/ode/collision/contact_choice.h"

namespace trundle {

namespace {

constexpr double kOnEnd = 0.999;      // cosine between contact normal and cylinder axis: the contact is on an end face
constexpr double kOneDirection = 0.9; // cosine; contacts with the same direction
constexpr double kSameDepth = 5e-5;   // m; smaller differences are decided by index, so that the choice is stable between ticks

double step(double depth) { return std::floor(depth / kSameDepth); }

/// At most `most` contacts: the deepest one, and others far apart from it and each other. The input may exceed the capacity of
/// one PointGroup.
std::vector<SurfaceContact> wellSpread(const std::vector<SurfaceContact>& contacts, int most) {
    dContactGeom found[kMaxFound];
    std::array<const SurfaceContact*, kMaxFound> from{};
    PointGroup group{};
    int count = 0;
    const auto choose = [&] {
        for (int i = 0; i < count; ++i) group[static_cast<std::size_t>(i)] = i;
        count = spread(found, group, count, most);
        std::array<const SurfaceContact*, kMaxFound> kept{};
        for (int i = 0; i < count; ++i)
            kept[static_cast<std::size_t>(i)] = from[static_cast<std::size_t>(group[static_cast<std::size_t>(i)])];
        return kept;
    };
    const auto take = [&](const SurfaceContact* c) {
        dContactGeom& g = found[count] = {};
        for (int k = 0; k < 3; ++k) g.pos[k] = c->position[k];
        g.depth = step(c->depth);
        from[static_cast<std::size_t>(count++)] = c;
    };
    for (const SurfaceContact& c : contacts) {
        if (count == kMaxFound) {
            const auto kept = choose();
            const int few = std::exchange(count, 0);
            for (int i = 0; i < few; ++i) take(kept[static_cast<std::size_t>(i)]);
        }
        take(&c);
    }
    const auto kept = choose();
    std::vector<SurfaceContact> few;
    for (int i = 0; i < count; ++i) few.push_back(*kept[static_cast<std::size_t>(i)]);
    return few;
}

void sortByDepth(std::vector<SurfaceContact>& contacts) {
    std::stable_sort(contacts.begin(), contacts.end(),
                     [](const SurfaceContact& x, const SurfaceContact& y) { return step(x.depth) > step(y.depth); });
}

/// Adds contacts that all have the same direction.
void addSpread(std::vector<SurfaceContact>& contacts, int most, std::vector<SurfaceContact>& out) {
    sortByDepth(contacts);
    const std::vector<SurfaceContact> kept = wellSpread(contacts, most);
    out.insert(out.end(), kept.begin(), kept.end());
}

} // namespace

void HullCollider::setBody(std::uint32_t index, FlatBody& body) const {
    const OdeGeom& g = m_objects.geoms[index];
    const Mat3 axes = m_objects.axesOf(g);
    if (g.shape == GeomShape::Box) return body.setBox(m_objects.centres[index], axes, g.half);
    if (g.shape == GeomShape::Cylinder) return body.setCylinder(m_objects.centres[index], axes, g.radius, g.half.z());
    body.clear();
    for (std::size_t i = 0; i + 2 < g.data->points.size(); i += 3)
        body.points.push_back(m_objects.centres[index] + axes * Vec3(&g.data->points[i]));
    for (std::size_t f = 0; 4 * f < g.data->polygons.size(); ++f) { // 3, a, b, c
        const unsigned* polygon = &g.data->polygons[4 * f];
        body.addTriangle(polygon[1], polygon[2], polygon[3], axes * Vec3(&g.data->planes[4 * f]));
    }
}

bool HullCollider::setFaces(std::uint32_t index, const Vec3& normal) {
    const OdeGeom& g = m_objects.geoms[index];
    const bool isEnd = g.shape == GeomShape::Cylinder && std::abs(m_objects.axesOf(g).col(2).dot(normal)) > kOnEnd;
    if (!isEnd && g.shape != GeomShape::Box && g.shape != GeomShape::Convex) return false;
    setBody(index, m_pair.first);
    return true;
}

bool HullCollider::meet(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& contacts) {
    return hullContacts(first, second, most, contacts) || hullOnMesh(first, second, most, contacts);
}

/// False if the pair is not a hull and a shape with flat faces, if only edges cross, or if a cylinder's lateral surface touches.
bool HullCollider::hullContacts(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out) {
    const GeomShape a = m_objects.geoms[first].shape, b = m_objects.geoms[second].shape;
    const auto flat = [](GeomShape s) { return s == GeomShape::Convex || s == GeomShape::Box || s == GeomShape::Cylinder; };
    if ((a != GeomShape::Convex && b != GeomShape::Convex) || !flat(a) || !flat(b)) return false;
    setBody(first, m_pair.first);
    setBody(second, m_pair.second);
    const FlatTouch& touch = m_pair.findContacts();
    if (touch.apart) return true;
    if (touch.contacts.empty()) return false;
    for (const std::uint32_t g : {first, second})
        if (m_objects.geoms[g].shape == GeomShape::Cylinder &&
            std::abs(touch.normal.dot(m_objects.axesOf(m_objects.geoms[g]).col(2))) < kOnEnd)
            return false;
    std::vector<SurfaceContact> contacts;
    for (const FlatContact& c : touch.contacts) contacts.push_back({c.position, touch.normal, std::max(c.depth, 0.0)});
    addSpread(contacts, most, out);
    return true;
}

/// The mesh triangles that touch the hull's bounding box, in world coordinates.
std::vector<Triangle> HullCollider::trianglesNear(std::uint32_t mesh, std::uint32_t hull) {
    const OdeGeom& m = m_objects.geoms[mesh];
    const Mat3 axes = m_objects.axesOf(m), across = axes.transpose() * m_objects.axesOf(m_objects.geoms[hull]);
    const Vec3 centre = axes.transpose() * (m_objects.centres[hull] - m_objects.centres[mesh]),
               reach = across.cwiseAbs() * m_objects.geoms[hull].half;
    const Vec3 lo = centre - reach, hi = centre + reach;
    m.data->triangleGrid.query({{lo.x(), lo.y(), lo.z()}, {hi.x(), hi.y(), hi.z()}}, m_near);
    std::vector<Triangle> triangles;
    for (const std::uint32_t t : m_near) {
        Triangle& triangle = triangles.emplace_back();
        for (std::size_t k = 0; k < 3; ++k)
            triangle[k] = m_objects.centres[mesh] + axes * Vec3(&m.data->points[3 * m.data->triangles[3 * t + k]]);
    }
    return triangles;
}

/// False if the pair is not a hull and a mesh, or if only edges cross.
bool HullCollider::hullOnMesh(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out) {
    const bool hullFirst = m_objects.geoms[first].shape == GeomShape::Convex;
    const std::uint32_t hull = hullFirst ? first : second, mesh = hullFirst ? second : first;
    if (m_objects.geoms[hull].shape != GeomShape::Convex || m_objects.geoms[mesh].shape != GeomShape::Mesh) return false;
    const std::vector<Triangle> near = trianglesNear(mesh, hull);
    setBody(hull, m_pair.first);
    std::vector<SurfaceContact> contacts = contactsOnSurface(m_pair.first, near);
    if (contacts.empty()) return near.empty();
    sortByDepth(contacts);
    for (int round = 0; round < kMaxDirections && !contacts.empty(); ++round) {
        const Vec3 way = contacts[0].normal;
        std::vector<SurfaceContact> group, others;
        for (const SurfaceContact& c : contacts) (c.normal.dot(way) < kOneDirection ? others : group).push_back(c);
        if (!hullFirst)
            for (SurfaceContact& c : group) c.normal = -c.normal;
        addSpread(group, most, out);
        contacts.swap(others);
    }
    return true;
}

} // namespace trundle
