#include "world/ode/collision/geom_collider.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include "world/ode/collision/contact_choice.h"
#include "world/ode/collision/cylinder_on_box.h"
#include "world/ode/collision/line_contacts.h"

namespace trundle {

namespace {

constexpr int kMaxKept = 4;           // per pair and direction
constexpr int kMaxOfRobots = 2;       // per pair of jointed actors, which rest on neither
constexpr double kSurelyClear = 1e-6; // m
constexpr double kUpright = 0.9;      // cosine of an axle to the z axis: 26 degrees

/// Whether a box is above the plane by more than rounding errors.
bool isClear(const Box3& box, const Vec3& normal, double distance) {
    double lowest = -distance;
    for (int k = 0; k < 3; ++k) lowest += normal[k] * (normal[k] > 0 ? box.lo[k] : box.hi[k]);
    return lowest > kSurelyClear;
}

} // namespace

/// A wheel with its axle upright is a disc on which things lie.
bool GeomCollider::isRolling(std::uint32_t index) const {
    const OdeGeom& g = m_objects.geoms[index];
    return g.wheel && std::abs(wheelPose(g, index).axle.z()) < kUpright;
}

WheelPose GeomCollider::wheelPose(const OdeGeom& geom, std::uint32_t index) const {
    return {m_objects.centres[index], turn(m_objects.bodies[geom.body].r, geom.axle), geom.radius};
}

OdeContact& GeomCollider::addContact(std::uint32_t first, std::uint32_t second, const double* position, const double* normal,
                                     double depth, Contacts& contacts) const {
    OdeContact& c = contacts.emplace_back();
    c.first = first;
    c.second = second;
    c.actor = m_objects.geoms[first].actor;
    c.partner = m_objects.geoms[second].actor;
    for (int k = 0; k < 3; ++k) {
        c.position[k] = position[k];
        c.normal[k] = normal[k];
    }
    c.depth = depth;
    return c;
}

void GeomCollider::meetPlane(std::uint32_t index, const GroundPlane& plane, Contacts& contacts) {
    const OdeGeom& g = m_objects.geoms[index];
    if (g.wheel) {
        const WheelPose wheel = wheelPose(g, index);
        GroundContact ground;
        const WheelContactResult answer = wheelOnPlane(wheel, plane.normal, plane.distance, ground);
        if (answer == WheelContactResult::Contact) {
            OdeContact& c = addContact(index, plane.geom, ground.position.data(), ground.normal.data(), ground.depth, contacts);
            Vec3::Map(c.slide) = wheel.axle.cross(ground.normal);
        }
        if (answer != WheelContactResult::Unknown) return;
    }
    if (g.shape == GeomShape::Sphere) sphereOnPlane(index, plane, contacts);
    else if (g.shape == GeomShape::Box) boxOnPlane(index, plane, contacts);
    else if (m_onHulls.clear(); m_hulls.standsOnPlane(index, plane, kMaxKept, m_onHulls))
        addHullContacts(index, plane.geom, contacts);
    else genericContacts(index, plane.geom, contacts);
}

void GeomCollider::addHullContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts) const {
    for (const SurfaceContact& c : m_onHulls) addContact(first, second, c.position.data(), c.normal.data(), c.depth, contacts);
}

void GeomCollider::sphereOnPlane(std::uint32_t index, const GroundPlane& plane, Contacts& contacts) const {
    const double r = m_objects.geoms[index].radius, depth = r - (plane.normal.dot(m_objects.centres[index]) - plane.distance);
    if (depth < 0) return;
    const Vec3 at = m_objects.centres[index] - r * plane.normal;
    addContact(index, plane.geom, at.data(), plane.normal.data(), depth, contacts);
}

void GeomCollider::boxOnPlane(std::uint32_t index, const GroundPlane& plane, Contacts& contacts) const {
    if (isClear(m_objects.boxes[index], plane.normal, plane.distance)) return;
    const OdeGeom& g = m_objects.geoms[index];
    const Mat3 axes = m_objects.axesOf(g);
    const Vec3 rise = (axes.transpose() * plane.normal).cwiseProduct(g.half);
    const double height = plane.normal.dot(m_objects.centres[index]) - plane.distance;
    if (height > rise.cwiseAbs().sum()) return;
    dContactGeom found[8];
    PointGroup group{};
    int count = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const double depth = -(height + sign.dot(rise));
        if (depth < 0) continue;
        const Vec3 at = m_objects.centres[index] + axes * g.half.cwiseProduct(sign);
        for (int k = 0; k < 3; ++k) found[count].pos[k] = at[k];
        found[count].depth = depth;
        group[static_cast<std::size_t>(count)] = count;
        ++count;
    }
    const int kept = spread(found, group, count, kMaxKept);
    for (int i = 0; i < kept; ++i) {
        const dContactGeom& c = found[group[static_cast<std::size_t>(i)]];
        addContact(index, plane.geom, c.pos, plane.normal.data(), c.depth, contacts);
    }
}

void GeomCollider::meet(std::uint32_t first, std::uint32_t second, Contacts& contacts) {
    const bool a = isRolling(first), b = isRolling(second);
    if (a != b) wheelAgainst(a ? first : second, a ? second : first, a, contacts);
    else genericContacts(first, second, contacts);
}

/// One contact per ground direction: exactly at the wheel's radius, at the centre of its tread.
void GeomCollider::wheelAgainst(std::uint32_t index, std::uint32_t other, bool wheelFirst, Contacts& contacts) {
    const OdeGeom &g = m_objects.geoms[index], &o = m_objects.geoms[other];
    if (NearTriangles::isSurface(o.shape)) return wheelOnSurface(index, other, wheelFirst, contacts);
    const WheelPose wheel = wheelPose(g, index);
    const auto emit = [&](const Vec3& position, const Vec3& outOfGround, double depth, bool rolling) {
        const Vec3 normal = wheelFirst ? outOfGround : Vec3(-outOfGround);
        OdeContact& c =
            addContact(wheelFirst ? index : other, wheelFirst ? other : index, position.data(), normal.data(), depth, contacts);
        if (rolling) Vec3::Map(c.slide) = wheel.axle.cross(outOfGround);
    };
    if (o.shape == GeomShape::Box) {
        GroundContact ground;
        const WheelContactResult answer = wheelOnBox(wheel, m_objects.centres[other], m_objects.axesOf(o), o.half, ground);
        if (answer == WheelContactResult::Contact) emit(ground.position, ground.normal, ground.depth, true);
        if (answer != WheelContactResult::Unknown) return;
    }
    dContactGeom found[kMaxFound];
    const int count = collide(index, other, found);
    UsedPoints used{};
    for (int round = 0; round < kMaxDirections; ++round) {
        Vec3 normal;
        const int deepest = takeGround(found, count, used, normal);
        if (deepest < 0) return;
        const dContactGeom& top = found[deepest];
        const Vec3 down = normal - normal.dot(wheel.axle) * wheel.axle;
        const double length = down.norm();
        if (length < kSideHit) emit(vec(top.pos), vec(top.normal), top.depth, false);
        else emit(wheel.centre - wheel.radius / length * down, normal, top.depth, true);
    }
}

/// Of a wheel that is a ball the sides are those of the ball.
void GeomCollider::wheelOnSurface(std::uint32_t index, std::uint32_t surface, bool wheelFirst, Contacts& contacts) {
    const OdeGeom& g = m_objects.geoms[index];
    const WheelPose wheel = wheelPose(g, index);
    const bool isBall = g.shape == GeomShape::Sphere;
    const std::span<const Triangle> near = m_near.find(surface, index);
    if (near.empty()) return;
    m_onTread.clear();
    m_onHulls.clear();
    wheelOnTriangles(wheel, isBall ? 0 : g.half.z(), near, m_onTread);
    if (isBall) ballOnTriangles(wheel.centre, g.radius, near, false, m_onHulls);
    else (void)m_hulls.meet(index, surface, kMaxKept, m_onHulls); // on its ends
    for (const SurfaceContact& c : m_onHulls)
        if (c.normal.cross(wheel.axle).norm() < kSideHit) m_onTread.push_back({c, false});
    for (const TreadContact& c : m_onTread) {
        const Vec3 normal = wheelFirst ? c.normal : Vec3(-c.normal);
        OdeContact& added = addContact(wheelFirst ? index : surface, wheelFirst ? surface : index, c.position.data(),
                                       normal.data(), c.depth, contacts);
        if (c.rolling) Vec3::Map(added.slide) = wheel.axle.cross(c.normal);
    }
}

/// 0 too where the two are no ball or cylinder and no surface of triangles.
int GeomCollider::roundOnSurface(std::uint32_t first, std::uint32_t second, dContactGeom* found) {
    const auto isRound = [this](std::uint32_t i) {
        return m_objects.geoms[i].shape == GeomShape::Sphere || m_objects.geoms[i].shape == GeomShape::Cylinder;
    };
    const auto isSurface = [this](std::uint32_t i) { return NearTriangles::isSurface(m_objects.geoms[i].shape); };
    const bool roundFirst = isRound(first) && isSurface(second);
    if (!roundFirst && (!isRound(second) || !isSurface(first))) return 0;
    const std::uint32_t index = roundFirst ? first : second, surface = roundFirst ? second : first;
    const OdeGeom& g = m_objects.geoms[index];
    const Vec3& centre = m_objects.centres[index];
    const std::span<const Triangle> near = m_near.find(surface, index);
    m_onHulls.clear();
    if (g.shape == GeomShape::Cylinder)
        cylinderOnTriangles({centre, m_objects.axesOf(g).col(2), g.radius}, g.half.z(), near, m_onHulls);
    else ballOnTriangles(centre, g.radius, near, m_objects.geoms[surface].shape != GeomShape::Mesh, m_onHulls);
    std::ranges::stable_sort(m_onHulls, std::greater(), &SurfaceContact::depth);
    const std::size_t most = std::min<std::size_t>(m_onHulls.size(), kMaxFound);
    for (std::size_t i = 0; i < most; ++i) {
        const SurfaceContact& c = m_onHulls[i];
        found[i] = {};
        for (int k = 0; k < 3; ++k) {
            found[i].pos[k] = c.position[k];
            found[i].normal[k] = (roundFirst ? 1 : -1) * c.normal[k];
        }
        found[i].depth = c.depth;
    }
    return static_cast<int>(most);
}

/// Of two geoms, mostly by ODE, normals towards the first; at most kMaxFound.
int GeomCollider::collide(std::uint32_t first, std::uint32_t second, dContactGeom* found) {
    const OdeGeom &a = m_objects.geoms[first], &b = m_objects.geoms[second];
    if (const int round = roundOnSurface(first, second, found)) return round;
    if (a.shape == GeomShape::Heightfield || b.shape == GeomShape::Heightfield) return collideAsMesh(first, second, found);
    const int count = dCollide(a.id, b.id, kMaxFound, found, sizeof(dContactGeom));
    const bool cylinderFirst = a.shape == GeomShape::Cylinder && b.shape == GeomShape::Box;
    if (count > 0 || (!cylinderFirst && (a.shape != GeomShape::Box || b.shape != GeomShape::Cylinder))) return count;
    const std::uint32_t cylinder = cylinderFirst ? first : second, box = cylinderFirst ? second : first;
    const OdeGeom &c = m_objects.geoms[cylinder], &o = m_objects.geoms[box];
    (void)cylinderOnBox({m_objects.centres[cylinder], m_objects.axesOf(c), c.radius, c.half.z()},
                        {m_objects.centres[box], m_objects.axesOf(o), o.half}, m_flat);
    FlatTouch& touch = m_flat.touch;
    std::ranges::sort(touch.contacts, std::greater(), &FlatContact::depth);
    const auto most = std::min<std::size_t>(touch.contacts.size(), kMaxFound);
    for (std::size_t i = 0; i < most; ++i) {
        dContactGeom& out = found[i];
        out = {};
        for (int k = 0; k < 3; ++k) {
            out.pos[k] = touch.contacts[i].position[k];
            out.normal[k] = (cylinderFirst ? 1 : -1) * touch.normal[k];
        }
        out.depth = std::max(0.0, touch.contacts[i].depth);
    }
    return static_cast<int>(most);
}

/// With the triangles of the one that is a height map, of which ODE knows only samples.
int GeomCollider::collideAsMesh(std::uint32_t first, std::uint32_t second, dContactGeom* found) {
    const OdeGeom &a = m_objects.geoms[first], &b = m_objects.geoms[second];
    const bool isSecond = b.shape == GeomShape::Heightfield;
    const dGeomID mesh = isSecond ? m_near.findAsMesh(second, first) : m_near.findAsMesh(first, second);
    return mesh ? dCollide(isSecond ? a.id : mesh, isSecond ? mesh : b.id, kMaxFound, found, sizeof(dContactGeom)) : 0;
}

int GeomCollider::mostContacts(std::uint32_t first, std::uint32_t second) const {
    const std::uint32_t a = m_objects.geoms[first].actor, b = m_objects.geoms[second].actor;
    const bool robots = b != kNoActor && m_objects.actors[a].jointed && m_objects.actors[b].jointed;
    return robots ? kMaxOfRobots : kMaxKept;
}

/// What touches a ball does so at its radius, as on a plane.
void GeomCollider::atRadius(std::uint32_t index, double side, dContactGeom* found, int count) const {
    const OdeGeom& g = m_objects.geoms[index];
    if (g.shape != GeomShape::Sphere) return;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) found[i].pos[k] = m_objects.centres[index][k] - side * g.radius * found[i].normal[k];
}

/// Fills `m_onHulls` where ODE has one point for a line. `normal`: towards the first.
bool GeomCollider::lineContacts(std::uint32_t first, std::uint32_t second, const Vec3& normal) {
    const auto isRound = [this](std::uint32_t i) {
        return m_objects.geoms[i].shape == GeomShape::Cylinder || m_objects.geoms[i].shape == GeomShape::Capsule;
    };
    const auto side = [this](std::uint32_t i) {
        const OdeGeom& g = m_objects.geoms[i];
        const bool isCapsule = g.shape == GeomShape::Capsule;
        return RoundSide{m_objects.centres[i], m_objects.axesOf(g).col(2), g.radius, g.half.z() - (isCapsule ? g.radius : 0),
                         isCapsule};
    };
    m_onHulls.clear();
    if (isRound(first) && isRound(second) && sideOnSide(side(first), side(second), normal, m_onHulls)) return true;
    if (isRound(first) && m_hulls.setFaces(second, normal) && sideOnFace(side(first), m_hulls.faces(), normal, m_onHulls))
        return true;
    if (!isRound(second) || !m_hulls.setFaces(first, normal) || !sideOnFace(side(second), m_hulls.faces(), -normal, m_onHulls))
        return false;
    for (SurfaceContact& c : m_onHulls) c.normal = -c.normal;
    return true;
}

void GeomCollider::genericContacts(std::uint32_t first, std::uint32_t second, Contacts& contacts) {
    const int most = mostContacts(first, second);
    m_onHulls.clear();
    dContactGeom found[kMaxFound];
    int count = 0;
    if (m_hulls.meet(first, second, most, m_onHulls)) {
        addHullContacts(first, second, contacts);
        count = roundOnSurface(first, second, found); // beside the end on which it is
    } else {
        count = collide(first, second, found);
    }
    if (count == 0) return;
    if (count == 1 && most > kMaxOfRobots && lineContacts(first, second, vec(found[0].normal)))
        return addHullContacts(first, second, contacts);
    atRadius(first, 1, found, count);
    atRadius(second, -1, found, count);
    UsedPoints used{};
    for (int round = 0; round < kMaxDirections; ++round) {
        PointGroup group{};
        const int size = takeDirection(found, count, used, group);
        if (size == 0) return;
        const int kept = spread(found, group, size, most);
        for (int i = 0; i < kept; ++i) {
            const dContactGeom& c = found[group[static_cast<std::size_t>(i)]];
            addContact(first, second, c.pos, c.normal, c.depth, contacts);
        }
    }
}

} // namespace trundle
