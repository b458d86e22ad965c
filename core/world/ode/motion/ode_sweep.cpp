#include "world/ode/motion/ode_sweep.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "world/ode/motion/free_rotation.h"
#include "world/ode/objects/ode_math.h"

namespace trundle {

namespace {

constexpr double kShare = 0.9;    // of its own thickness that a body may move unswept
constexpr double kGrazing = 0.01; // sine of the angle to a surface below which a body slides along it
constexpr int kMostSamples = 200; // of a path; what is thinner than that is found by its centre
constexpr int kHalvings = 24;
constexpr double kDeeper = 0.02; // of a thickness, that a contact may deepen in a tick
constexpr double kThrough = 0.5; // of the smaller half extent: as deep as that is what passes through another
constexpr std::size_t kMostPassages = 20;

Box3 around(const Box3& box, const Vec3& by) {
    Box3 moved = box;
    for (int k = 0; k < 3; ++k) {
        moved.lo[k] += by[k];
        moved.hi[k] += by[k];
    }
    moved.cover(box);
    return moved;
}

RawState stateOf(const OdeBody& b) {
    RawState s{};
    std::memcpy(s.p, b.p, sizeof s.p);
    std::memcpy(s.r, b.r, sizeof s.r);
    std::memcpy(s.q, b.q, sizeof s.q);
    std::memcpy(s.w, b.w, sizeof s.w);
    return s;
}

} // namespace

void OdeSweep::addScenery(const OdeGeom& g) {
    if (g.shape == GeomShape::Box) m_thinnestBox = std::min(m_thinnestBox, 2 * g.half.minCoeff());
}

/// ODE finds no contact of a cylinder of which an end has come out of the other side of a box.
double OdeSweep::thinnestFor(const OdeGeom& g) const {
    return g.shape == GeomShape::Cylinder && !g.wheel ? m_thinnestBox : HUGE_VAL;
}

/// How far a point of it may move in a tick, and be found before it is through.
double OdeSweep::safeWay(const OdeGeom& g) const {
    const double share = g.shape == GeomShape::Convex || g.shape == GeomShape::Mesh ? kShare / 2 : kShare;
    return share * std::min(g.half.minCoeff(), thinnestFor(g));
}

/// False if no point of it can pass a plane that it does not touch: its displacement lies within its own shape.
bool OdeSweep::outruns(const OdeGeom& g, double h) const {
    const OdeBody& b = m_objects.bodies[g.body];
    const Mat3 axes = m_objects.axesOf(g);
    const Vec3 turning = vec(b.w), moved = h * (axes.transpose() * (vec(b.v) + turning.cross(turn(b.r, g.offset))));
    if (g.shape == GeomShape::Sphere) return moved.squaredNorm() > kShare * kShare * g.radius * g.radius;
    Vec3 w = h * (axes.transpose() * turning).cwiseAbs();
    const bool round = g.shape == GeomShape::Cylinder || g.shape == GeomShape::Capsule;
    if (round) w.z() = 0;
    const Vec3& half = g.half;
    const Vec3 reach = moved.cwiseAbs() + Vec3(w.y() * half.z() + w.z() * half.y(), w.z() * half.x() + w.x() * half.z(),
                                               w.x() * half.y() + w.y() * half.x());
    const double share = g.shape == GeomShape::Convex || g.shape == GeomShape::Mesh ? kShare / 2 : kShare;
    const double most = thinnestFor(g);
    if (round)
        return std::hypot(reach.x(), reach.y()) > share * std::min(g.radius, most) ||
               reach.z() > share * std::min(half.z(), most);
    return (reach.array() > share * half.array()).any();
}

OdeSweep::Path OdeSweep::pathOf(std::uint32_t index, double h) const {
    const OdeBody& b = m_objects.bodies[index];
    const BodyState& s = m_objects.states[index];
    return {s.position + s.rotation * b.centre, vec(b.p), s.rotation, h * meanRate(s.rotation, quat(b.q), h, vec(b.w)), h};
}

void OdeSweep::put(std::uint32_t index, const Path& path, double t) {
    const OdeBody& b = m_objects.bodies[index];
    const Vec3 at = path.from + t * (path.to - path.from);
    dReal q[4];
    toOde(turnedBy(t * path.turned) * path.start, q);
    dBodySetPosition(b.id, at.x(), at.y(), at.z());
    dBodySetQuaternion(b.id, q);
    m_rotation.rewind(b, index, t * path.time);
    m_search.placeGeoms(b);
}

/// Bit for bit, which ODE's setter for rotations would not do.
void OdeSweep::putBack(std::uint32_t index, const RawState& s) {
    const OdeBody& b = m_objects.bodies[index];
    dBodySetPosition(b.id, s.p[0], s.p[1], s.p[2]);
    std::memcpy(const_cast<dReal*>(b.r), s.r, sizeof s.r);
    std::memcpy(const_cast<dReal*>(b.q), s.q, sizeof s.q);
    std::memcpy(const_cast<dReal*>(b.w), s.w, sizeof s.w);
    m_search.placeGeoms(b);
}

/// Needs the geom at the start of its path.
void OdeSweep::findObstacles(std::uint32_t geom, const Path& path) {
    const Vec3 way = path.to - path.from;
    m_obstacles.clear();
    for (std::uint32_t i = 0; i < m_objects.planes.size(); ++i) m_obstacles.push_back({m_objects.planes[i].geom, i, 0});
    if (!m_objects.statics.empty()) {
        Box3 box = m_objects.boxes[geom];
        const double bound = m_objects.geoms[geom].bound; // it may turn, and about a centre that is not its own
        const Vec3 lever = m_objects.centres[geom] - path.from;
        for (int k = 0; k < 3; ++k) {
            box.lo[k] -= bound + 2 * lever.norm();
            box.hi[k] += bound + 2 * lever.norm();
        }
        m_search.staticsNear(around(box, way), m_found);
        for (const std::uint32_t i : m_found) m_obstacles.push_back({m_objects.statics[i], kNone, 0});
    }
    for (Obstacle& o : m_obstacles) o.before = std::max(0.0, depthIn(geom, o, path));
}

/// How deep the geom is in what lies before it; negative: not at all. A point that comes no nearer to a surface than
/// one of a body that is not swept cannot pass within this tick. It counts only if it is deep, else
/// what rolls or topples would be held up.
double OdeSweep::depthIn(std::uint32_t geom, const Obstacle& obstacle, const Path& path) {
    m_contacts.clear();
    if (obstacle.plane != kNone) m_collider.meetPlane(geom, m_objects.planes[obstacle.plane], m_contacts);
    else if (m_objects.boxes[geom].touches(m_objects.boxes[obstacle.geom])) m_collider.meet(geom, obstacle.geom, m_contacts);
    const Vec3 centre = vec(m_objects.bodies[m_objects.geoms[geom].body].p), wayOfCentre = path.to - path.from;
    const double safe = safeWay(m_objects.geoms[geom]);
    double depth = -1;
    for (const OdeContact& c : m_contacts) {
        const Vec3 way = wayOfCentre + path.turned.cross(vec(c.position) - centre); // of the point, from now on
        const double nearer = -vec(c.normal).dot(way);
        if (nearer <= kGrazing * std::max(way.norm(), wayOfCentre.norm())) continue;
        if (nearer > safe || c.depth > kThrough * safe) depth = std::max(depth, c.depth);
    }
    return depth;
}

bool OdeSweep::isStopped(std::uint32_t geom, const Path& path, double t) {
    put(m_objects.geoms[geom].body, path, t);
    const double own = m_objects.geoms[geom].half.minCoeff();
    return std::any_of(m_obstacles.begin(), m_obstacles.end(), [&](const Obstacle& o) {
        const double depth = depthIn(geom, o, path);
        if (o.before == 0) return depth >= 0;
        const OdeGeom& other = m_objects.geoms[o.geom];
        const bool isSurface = o.plane != kNone || other.shape == GeomShape::Mesh; // has no thickness
        const double thickness = isSurface ? own : std::min(own, other.half.minCoeff());
        return depth > o.before + kDeeper * thickness; // there is a contact already
    });
}

/// The share of the path up to the first obstacle, 1 for all of it. A robot that stopped where its first geom touches would turn about
/// that point for a whole tick and tear its joints; so those of it stop only at what they would pass.
double OdeSweep::freeShare(std::uint32_t geom, const Path& path, bool jointed) {
    put(m_objects.geoms[geom].body, path, 0);
    findObstacles(geom, path);
    if (jointed) { // what it would be in at the end stops all its geoms together, as in any other tick
        put(m_objects.geoms[geom].body, path, 1);
        std::erase_if(m_obstacles, [&](const Obstacle& o) { return depthIn(geom, o, path) > 0; });
    }
    if (m_obstacles.empty()) return 1;
    const auto bounces = [&](std::uint32_t of) { return m_settings.surfaces[m_objects.geoms[of].surface].restitution > 0; };
    m_bounces = m_bounces || bounces(geom) ||
                std::any_of(m_obstacles.begin(), m_obstacles.end(), [&](const Obstacle& o) { return bounces(o.geom); });
    const OdeGeom& g = m_objects.geoms[geom];
    const double turned = path.turned.norm() * (g.bound + g.offset.norm());
    const double steps =
        std::clamp(std::ceil(((path.to - path.from).norm() + turned) / (kShare * std::min(g.half.minCoeff(), thinnestFor(g)))),
                   1.0, static_cast<double>(kMostSamples));
    double clear = 0, stopped = 2;
    for (int i = 1; i <= static_cast<int>(steps) && stopped > 1; ++i) {
        const double t = i / steps;
        if (isStopped(geom, path, t)) stopped = t;
        else clear = t;
    }
    if (stopped > 1) return 1;
    for (int i = 0; i < kHalvings && stopped - clear > 1e-7; ++i) {
        const double middle = (clear + stopped) / 2;
        (isStopped(geom, path, middle) ? stopped : clear) = middle;
    }
    return stopped;
}

/// How deep; negative: not at all. `ahead`: in a way that stops the first on its way.
double OdeSweep::touch(std::uint32_t first, std::uint32_t second, const Vec3& way, bool& ahead) {
    m_contacts.clear();
    if (m_objects.boxes[first].touches(m_objects.boxes[second])) m_collider.meet(first, second, m_contacts);
    ahead = std::any_of(m_contacts.begin(), m_contacts.end(), [&](const OdeContact& c) { return vec(c.normal).dot(way) < 0; });
    double depth = -1;
    for (const OdeContact& c : m_contacts) depth = std::max(depth, c.depth);
    return depth;
}

/// Has the geom met a geom of another actor on its way, and not in the end or from behind? What only brushed a corner has not.
void OdeSweep::findPassages(std::uint32_t geom, double h) {
    const OdeGeom& g = m_objects.geoms[geom];
    const Path own = pathOf(g.body, h);
    for (std::uint32_t a = 0; a < m_objects.actors.size() && m_passages.size() < kMostPassages; ++a) {
        const OdeActor& other = m_objects.actors[a];
        if (a == g.actor || other.geoms.begin == other.geoms.end) continue;
        const bool someApart = other.isApart && m_objects.actors[g.actor].isApart;
        if (someApart && OdeObjects::areApart(m_objects.apartActors, a, g.actor)) continue;
        const OdeBody& first = m_objects.bodies[other.bodies.begin];
        const Vec3 way = own.to - own.from - h * vec(first.v);
        if (!around(m_objects.boxes[geom], -way).touches(m_objects.actorBoxes[a])) continue;
        const bool known = std::any_of(m_passages.begin(), m_passages.end(), [&](const IndexPair& p) {
            const std::uint32_t x = m_objects.geoms[p.first].actor, y = m_objects.geoms[p.second].actor;
            return (x == a && y == g.actor) || (y == a && x == g.actor);
        });
        if (known) continue;
        for (std::uint32_t k = other.geoms.begin; k < other.geoms.end; ++k) {
            if (someApart && OdeObjects::areApart(m_objects.apartBodies, g.body, m_objects.geoms[k].body)) continue;
            const Path path = pathOf(m_objects.geoms[k].body, h);
            const RawState mine = stateOf(m_objects.bodies[g.body]), its = stateOf(m_objects.bodies[m_objects.geoms[k].body]);
            const double steps = std::clamp(std::ceil(way.norm() / (kShare * g.half.minCoeff())), 1.0, double(kMostSamples));
            const double thin = m_objects.geoms[k].half.minCoeff();
            if (way.norm() < g.half.minCoeff() + thin) continue; // not even from the first touch to its middle
            const double through = kThrough * std::min(g.half.minCoeff(), thin);
            bool met = false, ahead = false;
            for (int i = 0; i <= static_cast<int>(steps); ++i) {
                put(g.body, own, i / steps);
                put(m_objects.geoms[k].body, path, i / steps);
                const double depth = touch(geom, k, way, ahead);
                const bool touches = depth >= 0;
                if (i == 0 && touches) break; // they know of each other
                met = met || depth > through;
                if (i == static_cast<int>(steps) && met && !(touches && ahead)) m_passages.emplace_back(geom, k);
            }
            putBack(g.body, mine);
            putBack(m_objects.geoms[k].body, its);
        }
    }
}

/// Of a push along what a free body touches, the share that stops it; the rest turns it.
double OdeSweep::borneShare(std::uint32_t index) {
    const OdeBody& b = m_objects.bodies[index];
    m_contacts.clear();
    for (std::uint32_t k = b.geoms.begin; k < b.geoms.end; ++k) {
        for (const GroundPlane& plane : m_objects.planes) m_collider.meetPlane(k, plane, m_contacts);
        m_search.staticsNear(m_objects.boxes[k], m_found);
        for (const std::uint32_t i : m_found) m_collider.meet(k, m_objects.statics[i], m_contacts);
    }
    Vec3 point = Vec3::Zero(), normal = Vec3::Zero();
    for (const OdeContact& c : m_contacts) {
        point += vec(c.position) / static_cast<double>(m_contacts.size());
        normal += vec(c.normal);
    }
    if (normal.isZero(1e-6)) return 1; // between two walls
    const Vec3 turning = quat(b.q).conjugate() * (point - vec(b.p)).cross(normal.normalized());
    dMass mass;
    dBodyGetMass(b.id, &mass);
    return 1 / (1 + mass.mass * turning.dot(m_objects.inertias[index].inverse() * turning));
}

/// The whole actor, so that its joints stay closed. What flew has the velocity of that moment; what touches something only loses what
/// it fell faster than that, as a contact has already carried the weight of what rests. Where it does not bounce, the contact of the next
/// tick bears what one would have borne in the rest of this one: all of it under the centre of mass, little at a corner aside of it, where
/// more would turn the body faster than its fall does.
void OdeSweep::stopAt(std::uint32_t actor, double t, double h, std::span<const OdeContact> contacts) {
    const OdeActor& a = m_objects.actors[actor];
    const bool jointed = m_links.isJointed(actor);
    const bool flies = !jointed && std::none_of(contacts.begin(), contacts.end(),
                                                [&](const OdeContact& c) { return c.actor == actor || c.partner == actor; });
    for (std::uint32_t i = a.bodies.begin; i < a.bodies.end; ++i) {
        put(i, pathOf(i, h), t);
        if (jointed) continue;
        const OdeBody& b = m_objects.bodies[i];
        const BodyState& s = m_objects.states[i];
        const Vec3 start = s.linear + s.angular.cross(s.rotation * b.centre), late = (1 - t) * h * m_settings.gravity;
        Vec3 owed = (1 - t) * (vec(b.v) - start);
        if (!flies) owed = std::clamp(vec(b.v).dot(late) / std::max(late.squaredNorm(), 1e-300), 0.0, 1.0) * late;
        const Vec3 v = vec(b.v) - owed;
        dBodySetLinearVel(b.id, v.x(), v.y(), v.z());
        if (!flies || m_bounces) continue;
        dMass mass;
        dBodyGetMass(b.id, &mass);
        const Vec3 force = borneShare(i) * mass.mass / h * owed;
        dBodyAddForce(b.id, force.x(), force.y(), force.z());
    }
}

/// The share of its path that an actor may move.
double OdeSweep::shareOf(std::uint32_t index, double h) {
    const OdeActor& actor = m_objects.actors[index];
    double share = 1;
    m_bounces = false;
    for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) {
        const OdeBody& b = m_objects.bodies[i];
        if (b.geoms.begin == b.geoms.end) continue;
        const double most = h * (vec(b.v).norm() + vec(b.w).norm() * b.reach); // rarely more than a shape is thick
        if (!(most > kShare / 2 * std::min(b.thin, m_thinnestBox))) continue;
        m_fast.clear();
        for (std::uint32_t k = b.geoms.begin; k < b.geoms.end; ++k)
            if (outruns(m_objects.geoms[k], h)) m_fast.push_back(k);
        if (m_fast.empty()) continue;
        ++m_count;
        const Path path = pathOf(i, h);
        const RawState end = stateOf(b);
        for (const std::uint32_t geom : m_fast) share = std::min(share, freeShare(geom, path, m_links.isJointed(index)));
        putBack(i, end);
        for (const std::uint32_t geom : m_fast) findPassages(geom, h);
    }
    return share;
}

/// Actors that joints or latches join stop together, so that these stay closed.
void OdeSweep::run(double h, std::span<const OdeContact> contacts) {
    m_links.update(m_objects);
    for (std::uint32_t a = 0; a < m_objects.actors.size(); ++a) {
        if (!m_links.isFirst(a)) continue; // was moved with the first of its group
        double share = shareOf(a, h);
        for (std::uint32_t i = m_links.next(a); i != kNone; i = m_links.next(i)) share = std::min(share, shareOf(i, h));
        if (!(share < 1)) continue;
        for (std::uint32_t i = a; i != kNone; i = m_links.next(i)) stopAt(i, share, h, contacts);
    }
}

} // namespace trundle
