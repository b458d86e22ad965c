#include "world/ode/objects/ode_objects.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "world/ode/objects/ode_fault.h"

namespace trundle {

namespace {

constexpr double kRolling = 0.7; // cosine between an axis and the floor's normal

bool insertPair(std::vector<IndexPair>& pairs, std::uint32_t first, std::uint32_t second) {
    const IndexPair pair = std::minmax(first, second);
    const auto at = std::ranges::lower_bound(pairs, pair);
    if (at != pairs.end() && *at == pair) return false;
    pairs.insert(at, pair);
    return true;
}

} // namespace

OdeObjects::~OdeObjects() {
    try {
        for (auto g = geoms.rbegin(); g != geoms.rend(); ++g) // the last one is the first in the list of its body
            if (g->id) dGeomDestroy(g->id);
    } catch (const OdeFault&) { // after a fault some of it may not come apart: better lost than dead
    }
}

std::vector<IndexPair> OdeObjects::joinedActors() const {
    std::vector<IndexPair> joined;
    const auto add = [&](std::uint32_t first, std::uint32_t second) {
        if (second == kNone || bodies[first].actor == bodies[second].actor) return;
        (void)insertPair(joined, bodies[first].actor, bodies[second].actor);
    };
    for (const std::uint32_t link : links) add(joints[link].child, joints[link].parent);
    for (const OdeCoupling& coupling : couplings) add(coupling.first, coupling.second);
    for (const OdeLatch& latch : latches)
        if (latch.holds) add(latch.body, latch.held);
    return joined;
}

void OdeObjects::separateActors(std::uint32_t first, std::uint32_t second) {
    (void)insertPair(apartActors, first, second);
    actors[first].isApart = actors[second].isApart = true;
}

bool OdeObjects::separateBodies(std::uint32_t first, std::uint32_t second) {
    actors[bodies[first].actor].isApart = actors[bodies[second].actor].isApart = true;
    return insertPair(apartBodies, first, second);
}

void OdeObjects::reuniteBodies(std::uint32_t first, std::uint32_t second) {
    std::erase(apartBodies, IndexPair(std::minmax(first, second)));
}

bool OdeObjects::areApart(const std::vector<IndexPair>& pairs, std::uint32_t first, std::uint32_t second) {
    return std::ranges::binary_search(pairs, IndexPair(std::minmax(first, second)));
}

Vec3 OdeObjects::contactSpeed(const OdeContact& c) const {
    return pointVelocity(geoms[c.first], vec(c.position)) - pointVelocity(geoms[c.second], vec(c.position));
}

Vec3 OdeObjects::contactSpeed(const OdeContact& c, std::span<const RawState> before) const {
    const auto speed = [&](std::uint32_t geom) -> Vec3 {
        const std::uint32_t body = geoms[geom].body;
        if (body == kNone) return Vec3::Zero();
        return vec(bodies[body].v) + vec(bodies[body].w).cross(vec(c.position) - vec(before[body].p));
    };
    return speed(c.first) - speed(c.second);
}

bool OdeObjects::rolls(const OdeGeom& g, const Vec3& normal) const {
    if (g.shape == GeomShape::Sphere) return true;
    if (!g.wheel && g.shape != GeomShape::Cylinder && g.shape != GeomShape::Capsule) return false;
    const Vec3 axis = g.wheel ? turn(bodies[g.body].r, g.axle) : Vec3(axesOf(g).col(2));
    return std::abs(axis.dot(normal)) < kRolling; // else it lies on its face, as a turntable does
}

Vec3 OdeObjects::carriedBy(const OdeContact& c) const {
    const OdeGeom& g = geoms[c.first];
    return rolls(g, vec(c.normal)) ? vec(bodies[g.body].v) : pointVelocity(g, vec(c.position));
}

void OdeObjects::publish(std::uint32_t index) {
    const OdeBody& b = bodies[index];
    BodyState& s = states[index];
    const Vec3 lever = turn(b.r, b.centre); // from the frame's origin to the centre of mass
    s.position = vec(b.p) - lever;
    s.rotation = quat(b.q);
    s.angular = vec(b.w);
    s.linear = vec(b.v) - s.angular.cross(lever);
}

RawState rawState(const OdeBody& b) {
    RawState s;
    std::memcpy(s.p, b.p, sizeof s.p);
    std::memcpy(s.r, b.r, sizeof s.r);
    std::memcpy(s.q, b.q, sizeof s.q);
    std::memcpy(s.v, b.v, sizeof s.v);
    std::memcpy(s.w, b.w, sizeof s.w);
    std::memcpy(s.force, dBodyGetForce(b.id), sizeof s.force);
    std::memcpy(s.torque, dBodyGetTorque(b.id), sizeof s.torque);
    return s;
}

void setRawState(const OdeBody& b, const RawState& s) {
    std::memcpy(const_cast<dReal*>(b.p), s.p, sizeof s.p);
    std::memcpy(const_cast<dReal*>(b.r), s.r, sizeof s.r);
    std::memcpy(const_cast<dReal*>(b.q), s.q, sizeof s.q);
    std::memcpy(const_cast<dReal*>(b.v), s.v, sizeof s.v);
    std::memcpy(const_cast<dReal*>(b.w), s.w, sizeof s.w);
    dBodySetForce(b.id, s.force[0], s.force[1], s.force[2]);
    dBodySetTorque(b.id, s.torque[0], s.torque[1], s.torque[2]);
}

} // namespace trundle
