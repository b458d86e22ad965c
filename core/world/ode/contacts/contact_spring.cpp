// The spring of a contact. The ground's own is stiff and damped, and pushes what is deep inside out slowly; a surface with Softness is a
// spring in series with it, which loses as little as a joint's spring.
#include "world/ode/contacts/contact_rows.h"

#include <algorithm>
#include <cmath>

#include "world/spring_row.h"

namespace trundle {

namespace {

/// Of the ground's damping remains the sixth power of its share in the series: under 1 % of critical where a tick can follow the spring.
constexpr double kLossPower = 6;

} // namespace

/// Speed along `way` per impulse along it at a point of a geom, without joints and other contacts: 1/kg.
double ContactRows::mobility(std::uint32_t geom, const Vec3& point, const Vec3& way) const {
    if (m_geoms[geom].body == kNone) return 0;
    const OdeBody& b = m_bodies[m_geoms[geom].body];
    dMass mass;
    dBodyGetMass(b.id, &mass);
    Mat3 inertia;
    inertia << mass.I[0], mass.I[1], mass.I[2], mass.I[4], mass.I[5], mass.I[6], mass.I[8], mass.I[9], mass.I[10];
    const Vec3 arm = turnBack(b.r, (point - vec(b.p)).cross(way));
    return 1 / mass.mass + arm.dot(inertia.inverse() * arm);
}

/// Of the two actors, so that the heavier is carried.
const OdeActor& ContactRows::stiffer(const OdeContact& c) const {
    const OdeActor& first = m_objects.actors[c.actor];
    return c.partner == kNoActor || m_objects.actors[c.partner].stiffness < first.stiffness ? first : m_objects.actors[c.partner];
}

void ContactRows::fillSpring(const OdeContact& c, double h, dContact& out) const {
    const OdeActor& a2 = stiffer(c); // then both surfaces' give on top
    const OdeGeom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    const double softness = m_settings.surfaces[g1.surface].softness + m_settings.surfaces[g2.surface].softness;
    const double kp = softness > 0 ? 1 / (1 / a2.stiffness + softness) : a2.stiffness;
    SpringRow row{h * kp + a2.damping, 0};
    bool swings = false;
    if (softness > 0) {
        const Vec3 point = vec(c.position), normal = vec(c.normal);
        const double mass = 1 / (mobility(c.first, point, normal) + mobility(c.second, point, normal)),
                     kd = a2.damping * std::pow(kp / a2.stiffness, kLossPower);
        swings = springTurn(kp, kd, mass, h) <= kMaxSpringTurn;
        if (swings) row = springRow(kp, kd, mass, h);
    }
    dSurfaceParameters& s = out.surface;
    s.mode = dContactSoftERP | dContactSoftCFM;
    s.soft_erp = h * kp / row.give;
    s.soft_cfm = 1 / row.give;
    if (!swings) out.geom.depth = c.borne >= 0 ? c.borne : std::min(c.depth, kCorrectingSpeed * h / s.soft_erp);
    if (!swings && c.gap == 0) return;
    const Vec3 point = vec(c.position);
    s.mode |= dContactMotionN;
    s.motionN = -c.gap / h;
    if (swings)
        s.motionN -=
            row.carry / row.give * vec(c.normal).dot(m_objects.pointVelocity(g1, point) - m_objects.pointVelocity(g2, point));
}

} // namespace trundle
