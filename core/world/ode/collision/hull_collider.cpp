#include "world/ode/collision/hull_collider.h"

#include <algorithm>
#include <cmath>

#include "world/ode/collision/contact_choice.h"

namespace trundle {

namespace {

constexpr double kOnEnd = 0.3;        // cosine
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
        count = spreadWidely(found, group, count, most);
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

void addWidest(std::vector<SurfaceContact>& contacts, int most, std::vector<SurfaceContact>& out) {
    keepWidest(contacts, most);
    out.insert(out.end(), contacts.begin(), contacts.end());
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
    const bool isEnd = g.shape == GeomShape::Cylinder && std::abs(m_objects.axesOf(g).col(2).dot(normal)) > kFlush;
    if (!isEnd && g.shape != GeomShape::Box && g.shape != GeomShape::Convex) return false;
    setBody(index, m_pair.first);
    return true;
}

bool HullCollider::meet(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& contacts) {
    return endContacts(first, second, most, contacts) || hullContacts(first, second, most, contacts) ||
           hullOnMesh(first, second, most, contacts);
}

/// That end of a cylinder which is farther that way.
RoundEnd HullCollider::endTowards(std::uint32_t index, const Vec3& way) const {
    const OdeGeom& g = m_objects.geoms[index];
    const Vec3 axis = m_objects.axesOf(g).col(2), outward = axis.dot(way) < 0 ? Vec3(-axis) : axis;
    return {m_objects.centres[index] + g.half.z() * outward, outward, g.radius};
}

bool HullCollider::standsOnPlane(std::uint32_t index, const GroundPlane& plane, int most, std::vector<SurfaceContact>& out) {
    if (m_objects.geoms[index].shape != GeomShape::Cylinder) return false;
    const RoundEnd end = endTowards(index, -plane.normal);
    if (-end.outward.dot(plane.normal) < kOnEnd) return false; // else it lies
    m_ends.clear();
    endOnPlane(end, plane.normal, plane.distance, m_ends);
    addWidest(m_ends, most, out);
    return true;
}

/// Returns how far they overlap across the normal, m; nothing is added where no end is on a side.
double HullCollider::endOnBox(std::uint32_t cylinder, std::uint32_t box, std::vector<SurfaceContact>& out) const {
    const OdeGeom& g = m_objects.geoms[box];
    const Mat3 axes = m_objects.axesOf(g);
    const Vec3 axis = axes.transpose() * m_objects.axesOf(m_objects.geoms[cylinder]).col(2),
               from = axes.transpose() * (m_objects.centres[cylinder] - m_objects.centres[box]);
    int k = 0;
    if (axis.cwiseAbs().maxCoeff(&k) < kFlush || std::abs(from[k]) < g.half[k]) return 0;
    const int u = (k + 1) % 3, v = (k + 2) % 3;
    const double sign = from[k] < 0 ? -1 : 1;
    const Vec3 outward = sign * axes.col(k);
    const RoundEnd end = endTowards(cylinder, -outward);
    endOnSide(end, {m_objects.centres[box] + g.half[k] * outward, outward, axes.col(u), axes.col(v), g.half[u], g.half[v]}, out);
    return end.radius + std::min(g.half[u] - std::abs(from[u]), g.half[v] - std::abs(from[v]));
}

/// The same of an end on an end, which is the ground.
double HullCollider::endOnCylinder(std::uint32_t first, std::uint32_t second, std::vector<SurfaceContact>& out) const {
    const Vec3 from = m_objects.centres[first] - m_objects.centres[second];
    const RoundEnd ground = endTowards(second, from), end = endTowards(first, -from);
    const double above = from.dot(ground.outward);
    if (-end.outward.dot(ground.outward) < kFlush || above < m_objects.geoms[second].half.z()) return 0;
    endOnEnd(end, ground, out);
    return end.radius + ground.radius - (from - above * ground.outward).norm();
}

/// False unless an end of a cylinder is on a side of a box or on an end of another one.
bool HullCollider::endContacts(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out) {
    const GeomShape a = m_objects.geoms[first].shape, b = m_objects.geoms[second].shape;
    const bool both = a == GeomShape::Cylinder && b == GeomShape::Cylinder,
               boxFirst = a == GeomShape::Box && b == GeomShape::Cylinder;
    if (!both && !boxFirst && (a != GeomShape::Cylinder || b != GeomShape::Box)) return false;
    m_ends.clear();
    const double across = both       ? endOnCylinder(first, second, m_ends)
                          : boxFirst ? endOnBox(second, first, m_ends)
                                     : endOnBox(first, second, m_ends);
    // Where they overlap less across the normal than along it, one is beside the other.
    if (m_ends.empty() || std::ranges::max(m_ends, {}, &SurfaceContact::depth).depth > across) return false;
    if (boxFirst)
        for (SurfaceContact& c : m_ends) c.normal = -c.normal;
    addWidest(m_ends, most, out);
    return true;
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
    std::vector<SurfaceContact> contacts;
    for (const FlatContact& c : touch.contacts) contacts.push_back({c.position, touch.normal, std::max(c.depth, 0.0)});
    if ((a == GeomShape::Cylinder && !areOnEnds(first, contacts)) || (b == GeomShape::Cylinder && !areOnEnds(second, contacts)))
        return false;
    addSpread(contacts, most, out);
    return true;
}

/// Not on the lateral surface of the cylinder.
bool HullCollider::areOnEnds(std::uint32_t cylinder, const std::vector<SurfaceContact>& contacts) const {
    const Vec3 axis = m_objects.axesOf(m_objects.geoms[cylinder]).col(2);
    return std::ranges::all_of(contacts, [&](const SurfaceContact& c) { return std::abs(c.normal.dot(axis)) >= kFlush; });
}

/// Whether an end of the cylinder is as level as one of the triangles, and no farther above it than its rim reaches down.
bool HullCollider::isFlushWith(std::uint32_t cylinder, std::span<const Triangle> triangles) const {
    const Vec3 axis = m_objects.axesOf(m_objects.geoms[cylinder]).col(2);
    return std::ranges::any_of(triangles, [&](const Triangle& t) {
        const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
        if (std::abs(normal.dot(axis)) < kFlush) return false;
        const Vec3 up = normal.dot(m_objects.centres[cylinder] - t[0]) < 0 ? Vec3(-normal) : normal;
        const RoundEnd end = endTowards(cylinder, -up);
        return up.dot(end.centre - t[0]) < end.radius * kFlushSlope;
    });
}

/// Whether contacts on an end of a cylinder overlap its round side less than the end: it is beside them.
bool HullCollider::isBeside(std::uint32_t cylinder, const std::vector<SurfaceContact>& onEnd) const {
    const OdeGeom& g = m_objects.geoms[cylinder];
    Vec3 middle = Vec3::Zero();
    double deepest = 0;
    for (const SurfaceContact& c : onEnd) {
        middle += c.position / static_cast<double>(onEnd.size());
        deepest = std::max(deepest, c.depth);
    }
    return g.radius - (middle - m_objects.centres[cylinder]).cross(m_objects.axesOf(g).col(2)).norm() < deepest;
}

/// False if the pair is not a mesh or height map and a hull, a box or a cylinder that stands on it, or if only edges cross.
bool HullCollider::hullOnMesh(std::uint32_t first, std::uint32_t second, int most, std::vector<SurfaceContact>& out) {
    const auto isMesh = [this](std::uint32_t i) {
        return m_objects.geoms[i].shape == GeomShape::Mesh || m_objects.geoms[i].shape == GeomShape::Heightfield;
    };
    const bool hullFirst = isMesh(second);
    const std::uint32_t hull = hullFirst ? first : second, mesh = hullFirst ? second : first;
    const GeomShape shape = m_objects.geoms[hull].shape;
    const bool isCylinder = shape == GeomShape::Cylinder;
    if (!isMesh(mesh) || (shape != GeomShape::Convex && shape != GeomShape::Box && !isCylinder)) return false;
    const std::span<const Triangle> near = m_near.find(mesh, hull);
    if (isCylinder && !isFlushWith(hull, near)) return false;
    setBody(hull, m_pair.first);
    std::vector<SurfaceContact> contacts = contactsOnSurface(m_pair.first, near);
    if (isCylinder) { // its round side is not one of this body
        const Vec3 axis = m_objects.axesOf(m_objects.geoms[hull]).col(2);
        std::erase_if(contacts, [&](const SurfaceContact& c) { return std::abs(c.normal.dot(axis)) < kFlush; });
    }
    if (contacts.empty()) return near.empty();
    sortByDepth(contacts);
    for (int round = 0; round < kMaxDirections && !contacts.empty(); ++round) {
        const Vec3 way = contacts[0].normal;
        std::vector<SurfaceContact> group, others;
        for (const SurfaceContact& c : contacts) (c.normal.dot(way) < kOneDirection ? others : group).push_back(c);
        if (!hullFirst)
            for (SurfaceContact& c : group) c.normal = -c.normal;
        if (isCylinder && isBeside(hull, group)) {
            contacts.swap(others);
            continue;
        }
        if (isCylinder) addWidest(group, most, out);
        else addSpread(group, most, out);
        contacts.swap(others);
    }
    return true;
}

} // namespace trundle
