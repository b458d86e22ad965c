// Pairs and contacts. Method: bounding boxes around everything; for each actor first planes, then statics, then partners, each in
// index order, so that contacts are sorted by (actor, partner, geom). Balls, boxes and wheels on planes, and wheels on boxes, are
// computed in closed form; all other pairs use dCollide, always as (lower, higher), reduced to a few well-spread points.
#include "world/ode/ode_engine.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "world/ode/contact_choice.h"

namespace trundle {

namespace {

constexpr int kMaxKept = 4;     // per pair and direction
constexpr int kMaxOfRobots = 2; // per pair of jointed actors
constexpr int kMaxDirections = 3;
constexpr double kSurelyClear = 1e-6; // m

/// Whether a box is above the plane by more than rounding errors.
bool isClear(const Box3& box, const Vec3& normal, double distance) {
    double lowest = -distance;
    for (int k = 0; k < 3; ++k) lowest += normal[k] * (normal[k] > 0 ? box.lo[k] : box.hi[k]);
    return lowest > kSurelyClear;
}

} // namespace

Mat3 OdeEngine::axesOf(const Geom& geom) const {
    if (geom.body == kNone) return geom.axes;
    const Mat3 body = matrix(m_bodies[geom.body].r);
    return geom.turned ? Mat3(body * geom.axes) : body;
}

WheelPose OdeEngine::wheelPose(const Geom& geom, std::uint32_t index) const {
    return {m_centres[index], turn(m_bodies[geom.body].r, geom.axle), geom.radius};
}

SweepScene OdeEngine::sweepScene() {
    return {m_actors,
            m_bodies,
            m_states,
            m_geoms,
            m_planes,
            m_statics,
            m_centres,
            m_boxes,
            m_actorBoxes,
            m_settings.gravity,
            m_settings.surfaces,
            m_grid,
            m_contacts,
            [this](const Body& body) { placeGeoms(body); },
            [this](std::uint32_t geom, const GroundPlane& plane) { geomOnPlane(geom, plane); },
            [this](std::uint32_t first, std::uint32_t second) { collideGeoms(first, second); },
            [this](const Geom& geom) { return axesOf(geom); },
            [this](std::uint32_t body, double time) { m_rotation.rewind(m_bodies[body], body, time); }};
}

void OdeEngine::placeGeoms(const Body& body) {
    for (std::uint32_t i = body.geoms.begin; i < body.geoms.end; ++i) {
        const Geom& g = m_geoms[i];
        const Vec3 c = vec(body.p) + turn(body.r, g.offset);
        Vec3 half = Vec3::Constant(g.bound);
        if (!g.wheel && g.shape != GeomShape::Sphere) half = half.cwiseMin(axesOf(g).cwiseAbs() * g.half);
        m_centres[i] = c;
        m_boxes[i] = {{c.x() - half.x(), c.y() - half.y(), c.z() - half.z()},
                      {c.x() + half.x(), c.y() + half.y(), c.z() + half.z()}};
    }
}

void OdeEngine::updateBoxes() {
    for (std::uint32_t a = 0; a < m_actors.size(); ++a) {
        const Actor& actor = m_actors[a];
        Box3 all{{1e300, 1e300, 1e300}, {-1e300, -1e300, -1e300}};
        for (std::uint32_t b = actor.bodies.begin; b < actor.bodies.end; ++b) {
            placeGeoms(m_bodies[b]);
            for (std::uint32_t i = m_bodies[b].geoms.begin; i < m_bodies[b].geoms.end; ++i) all.cover(m_boxes[i]);
        }
        if (all.lo[0] > all.hi[0]) all = {{0, 0, -1e30}, {0, 0, -1e30}}; // never collides: placed far away
        m_actorBoxes[a] = all;
    }
}

void OdeEngine::collide() {
    m_contacts.clear();
    m_pairGrid.pairs(m_actorBoxes, m_pairs);
    std::size_t pair = 0;
    for (std::uint32_t a = 0; a < m_actors.size(); ++a) {
        const Actor& actor = m_actors[a];
        if (actor.geoms.begin == actor.geoms.end) {
            while (pair < m_pairs.size() && m_pairs[pair].first == a) ++pair;
            continue;
        }
        collideWithGround(a);
        for (const auto& [first, second] : actor.selfPairs)
            if (m_boxes[first].touches(m_boxes[second])) collideGeoms(first, second);
        for (; pair < m_pairs.size() && m_pairs[pair].first == a; ++pair) {
            const Actor& partner = m_actors[m_pairs[pair].second];
            for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i) {
                if (!m_boxes[i].touches(m_actorBoxes[m_pairs[pair].second])) continue;
                for (std::uint32_t k = partner.geoms.begin; k < partner.geoms.end; ++k)
                    if (m_boxes[i].touches(m_boxes[k])) collideGeoms(i, k);
            }
        }
    }
}

void OdeEngine::collideWithGround(std::uint32_t a) {
    const Actor& actor = m_actors[a];
    for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i)
        for (const GroundPlane& plane : m_planes) {
            const Vec3& n = plane.normal;
            const double height = n.dot(m_centres[i]) - plane.distance;
            if (height <= m_geoms[i].bound) geomOnPlane(i, plane);
        }
    if (m_statics.empty()) return;
    m_grid.query(m_actorBoxes[a], m_found);
    if (m_found.empty()) return;
    for (std::uint32_t i = actor.geoms.begin; i < actor.geoms.end; ++i)
        for (const std::uint32_t found : m_found)
            if (m_boxes[i].touches(m_boxes[m_statics[found]])) collideGeoms(i, m_statics[found]);
}

OdeEngine::Contact& OdeEngine::addContact(std::uint32_t first, std::uint32_t second, const double* position, const double* normal,
                                          double depth) {
    Contact& c = m_contacts.emplace_back();
    c.first = first;
    c.second = second;
    c.actor = m_geoms[first].actor;
    c.partner = m_geoms[second].actor;
    for (int k = 0; k < 3; ++k) {
        c.position[k] = position[k];
        c.normal[k] = normal[k];
    }
    c.depth = depth;
    return c;
}

void OdeEngine::geomOnPlane(std::uint32_t index, const GroundPlane& plane) {
    const Geom& g = m_geoms[index];
    if (g.wheel) {
        const WheelPose wheel = wheelPose(g, index);
        GroundContact ground;
        const WheelContactResult answer = wheelOnPlane(wheel, plane.normal, plane.distance, ground);
        if (answer == WheelContactResult::Contact) {
            Contact& c = addContact(index, plane.geom, ground.position.data(), ground.normal.data(), ground.depth);
            Vec3::Map(c.slide) = wheel.axle.cross(ground.normal);
        }
        if (answer != WheelContactResult::Unknown) return;
    }
    if (g.shape == GeomShape::Sphere) sphereOnPlane(index, plane);
    else if (g.shape == GeomShape::Box) boxOnPlane(index, plane);
    else genericContacts(index, plane.geom);
}

void OdeEngine::sphereOnPlane(std::uint32_t index, const GroundPlane& plane) {
    const double r = m_geoms[index].radius, depth = r - (plane.normal.dot(m_centres[index]) - plane.distance);
    if (depth < 0) return;
    const Vec3 at = m_centres[index] - r * plane.normal;
    addContact(index, plane.geom, at.data(), plane.normal.data(), depth);
}

void OdeEngine::boxOnPlane(std::uint32_t index, const GroundPlane& plane) {
    if (isClear(m_boxes[index], plane.normal, plane.distance)) return;
    const Geom& g = m_geoms[index];
    const Mat3 axes = axesOf(g);
    const Vec3 rise = (axes.transpose() * plane.normal).cwiseProduct(g.half);
    const double height = plane.normal.dot(m_centres[index]) - plane.distance;
    if (height > rise.cwiseAbs().sum()) return;
    dContactGeom found[8];
    PointGroup group{};
    int count = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 sign(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1);
        const double depth = -(height + sign.dot(rise));
        if (depth < 0) continue;
        const Vec3 at = m_centres[index] + axes * g.half.cwiseProduct(sign);
        for (int k = 0; k < 3; ++k) found[count].pos[k] = at[k];
        found[count].depth = depth;
        group[static_cast<std::size_t>(count)] = count;
        ++count;
    }
    const int kept = spread(found, group, count, kMaxKept);
    for (int i = 0; i < kept; ++i) {
        const dContactGeom& c = found[group[static_cast<std::size_t>(i)]];
        addContact(index, plane.geom, c.pos, plane.normal.data(), c.depth);
    }
}

void OdeEngine::collideGeoms(std::uint32_t first, std::uint32_t second) {
    const bool a = m_geoms[first].wheel, b = m_geoms[second].wheel;
    if (a != b) wheelAgainst(a ? first : second, a ? second : first, a);
    else genericContacts(first, second);
}

/// One contact per ground direction: exactly at the wheel's radius, at the centre of its tread.
void OdeEngine::wheelAgainst(std::uint32_t index, std::uint32_t other, bool wheelFirst) {
    const Geom &g = m_geoms[index], &o = m_geoms[other];
    const WheelPose wheel = wheelPose(g, index);
    const auto emit = [&](const Vec3& position, const Vec3& outOfGround, double depth, bool rolling) {
        const Vec3 normal = wheelFirst ? outOfGround : Vec3(-outOfGround);
        Contact& c = addContact(wheelFirst ? index : other, wheelFirst ? other : index, position.data(), normal.data(), depth);
        if (rolling) Vec3::Map(c.slide) = wheel.axle.cross(outOfGround);
    };
    if (o.shape == GeomShape::Box) {
        GroundContact ground;
        const WheelContactResult answer = wheelOnBox(wheel, m_centres[other], axesOf(o), o.half, ground);
        if (answer == WheelContactResult::Contact) emit(ground.position, ground.normal, ground.depth, true);
        if (answer != WheelContactResult::Unknown) return;
    }
    const bool rough = o.shape == GeomShape::Mesh || o.shape == GeomShape::Heightfield;
    dContactGeom found[kMaxFound];
    const int count = dCollide(rough && g.asSphere ? g.asSphere : g.id, o.id, kMaxFound, found, sizeof(dContactGeom));
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

int OdeEngine::mostContacts(std::uint32_t first, std::uint32_t second) const {
    const bool robots =
        m_geoms[second].actor != kNoActor && m_actors[m_geoms[first].actor].jointed && m_actors[m_geoms[second].actor].jointed;
    return robots ? kMaxOfRobots : kMaxKept;
}

void OdeEngine::genericContacts(std::uint32_t first, std::uint32_t second) {
    if (hullContacts(first, second) || hullOnMesh(first, second)) return;
    dContactGeom found[kMaxFound];
    const int count = dCollide(m_geoms[first].id, m_geoms[second].id, kMaxFound, found, sizeof(dContactGeom));
    if (count == 0) return;
    UsedPoints used{};
    for (int round = 0; round < kMaxDirections; ++round) {
        PointGroup group{};
        const int size = takeDirection(found, count, used, group);
        if (size == 0) return;
        const int kept = spread(found, group, size, mostContacts(first, second));
        for (int i = 0; i < kept; ++i) {
            const dContactGeom& c = found[group[static_cast<std::size_t>(i)]];
            addContact(first, second, c.pos, c.normal, c.depth);
        }
    }
}

} // namespace trundle
