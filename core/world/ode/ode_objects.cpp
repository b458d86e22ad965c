#include "world/ode/ode_objects.h"

#include <cmath>

#include "world/ode/ode_fault.h"

namespace trundle {

namespace {

constexpr double kRolling = 0.7; // cosine between an axis and the floor's normal

} // namespace

OdeObjects::~OdeObjects() {
    try {
        for (OdeGeom& g : geoms) {
            if (g.id) dGeomDestroy(g.id);
            if (g.asSphere) dGeomDestroy(g.asSphere);
        }
    } catch (const OdeFault&) { // after a fault some of it may not come apart: better lost than dead
    }
}

Vec3 OdeObjects::contactSpeed(const OdeContact& c) const {
    return pointVelocity(geoms[c.first], vec(c.position)) - pointVelocity(geoms[c.second], vec(c.position));
}

Vec3 OdeObjects::carriedBy(const OdeContact& c) const {
    const OdeGeom& g = geoms[c.first];
    const bool rolls = g.wheel || g.shape == GeomShape::Sphere ||
                       ((g.shape == GeomShape::Cylinder || g.shape == GeomShape::Capsule) &&
                        std::abs(axesOf(g).col(2).dot(vec(c.normal))) < kRolling);
    return rolls ? vec(bodies[g.body].v) : pointVelocity(g, vec(c.position));
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

} // namespace trundle
