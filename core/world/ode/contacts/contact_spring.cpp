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
constexpr double kBlowRest = 50; // the speed before a blow by that after it, at least
constexpr double kNoWork = 1e-9; // of the energy that goes back and forth

/// N that both of the last two ticks had.
double lastingLoad(const OdeContact& c) { return c.ticks < 2 ? 0 : std::min(c.load, c.earlier); }

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

/// An actor's contacts are as stiff as its own weight needs. What lies on it presses them as well: that share more. A surface with Softness
/// has the same spring all the time, as what a spring takes is what it gives back.
double ContactRows::stiffening(const OdeContact& c) const {
    if (softness(c) > 0) return 1;
    return std::max(1.0, lastingLoad(c) / (stiffer(c).stiffness * kFewestSupports * kMaxSag));
}

double ContactRows::sag(const OdeContact& c) const {
    const double load = lastingLoad(c), most = (stiffening(c) > 1 ? kFewestSupports : 1) * kMaxSag;
    return std::min(most, load / stiffness(c));
}

/// N s/m with which a blow without restitution leaves at most a fiftieth of the speed, however short the tick and large the masses: of the
/// first tick of a contact. 0: of none.
double ContactRows::blowDamping(const OdeContact& c, double h) const {
    if (c.ticks > 0 || c.bounces || !(c.speed < -kCorrectingSpeed)) return 0;
    const double own = m_objects.actors[c.actor].mass;
    const double other = c.partner == kNoActor ? 0 : 1 / m_objects.actors[c.partner].mass;
    return kBlowRest / (1 / own + other) / h;
}

double ContactRows::softness(const OdeContact& c) const {
    return m_settings.surfaces[m_geoms[c.first].surface].softness + m_settings.surfaces[m_geoms[c.second].surface].softness;
}

/// That a force along the normal moves.
double ContactRows::mass(const OdeContact& c) const {
    const Vec3 point = vec(c.position), normal = vec(c.normal);
    return 1 / (mobility(c.first, point, normal) + mobility(c.second, point, normal));
}

double ContactRows::springStiffness(const OdeContact& c) const {
    const double own = stiffness(c), soft = softness(c);
    return soft > 0 ? 1 / (1 / own + soft) : own;
}

void ContactRows::startSprings(std::span<OdeContact> contacts, double h) const {
    for (OdeContact& c : contacts) {
        if (c.ticks > 0 || !(softness(c) > 0)) continue;
        const double pressed = std::max(0.0, c.depth + std::min(0.0, c.speed * h));
        c.stored = springStiffness(c) * pressed * pressed / 2;
    }
}

/// That along the mean of the velocities before and after.
double ContactRows::work(const OdeContact& c, const dJointFeedback& force, std::span<const RawState> before, double h) const {
    if (before.empty() || !(softness(c) > 0)) return 0; // the quick solver keeps no states
    const Vec3 normal = vec(c.normal);
    return h * normal.dot(vec(force.f1)) * (c.speed + normal.dot(m_objects.contactSpeed(c, before))) / 2;
}

/// Method: an impulse J on a mass m, whose speed was s before and would be f without it, does the work J (s + f + J / m) / 2.
std::span<const std::uint32_t> ContactRows::findThrown(TickContacts& contacts, std::span<const RawState> before, double h) {
    m_thrown.clear();
    for (std::uint32_t i = 0; i < contacts.all.size(); ++i) {
        OdeContact& c = contacts.all[i];
        if (!contacts.rows[i] || c.bounces || !(softness(c) > 0)) continue;
        const double impulse = h * vec(c.normal).dot(vec(contacts.feedbacks[i].f1)),
                     after = vec(c.normal).dot(m_objects.contactSpeed(c, before));
        const double scale = impulse * (std::abs(c.speed) + std::abs(after));
        if (c.depth - h * after > 0 || !(work(c, contacts.feedbacks[i], before, h) > c.stored + kNoWork * scale)) continue;
        const double m = mass(c), sum = c.speed + after - impulse / m;
        const double rest = m / 2 * (std::sqrt(std::max(0.0, sum * sum + 8 * c.stored / m)) - sum);
        c.less += impulse - std::clamp(rest, 0.0, impulse);
        m_thrown.push_back(i);
    }
    return m_thrown;
}

bool ContactRows::landsOnSprings(const OdeContact& c) const {
    if (c.ticks > 0 || c.iterated || !(c.speed < -kCorrectingSpeed) || m_settings.solver == SolverChoice::Quick) return false;
    return m_objects.actors[c.actor].sprung || (c.partner != kNoActor && m_objects.actors[c.partner].sprung);
}

void ContactRows::fillSpring(const OdeContact& c, double h, dContact& out) const {
    const OdeActor& a2 = stiffer(c); // then both surfaces' give on top
    const OdeGeom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    const double kp = springStiffness(c), soft = softness(c), damping = stiffening(c) * a2.damping;
    SpringRow row{h * kp + damping, 0};
    bool swings = false;
    if (soft > 0) {
        const double m = mass(c), kd = damping * std::pow(kp / stiffness(c), kLossPower);
        swings = springTurn(kp, kd, m, h) <= kMaxSpringTurn;
        if (swings) row = springRow(kp, kd, m, h);
    }
    if (soft == 0) row.give = std::max(row.give, blowDamping(c, h));
    dSurfaceParameters& s = out.surface;
    s.mode = dContactSoftERP | dContactSoftCFM;
    s.soft_erp = h * kp / row.give;
    s.soft_cfm = 1 / row.give;
    if (!swings && c.borne >= 0) out.geom.depth = c.borne;
    else if (!swings && soft == 0 && landsOnSprings(c)) out.geom.depth = std::min(c.depth, -c.speed * h) / s.soft_erp;
    else if (!swings) out.geom.depth = std::min(c.depth, kCorrectingSpeed * h / s.soft_erp);
    if (!swings && c.gap == 0 && c.less == 0) return;
    const Vec3 point = vec(c.position);
    s.mode |= dContactMotionN;
    s.motionN = -c.gap / h;
    if (c.less > 0) s.motionN -= c.less * (1 / (h * row.give) + 1 / mass(c));
    if (swings)
        s.motionN -=
            row.carry / row.give * vec(c.normal).dot(m_objects.pointVelocity(g1, point) - m_objects.pointVelocity(g2, point));
}

} // namespace trundle
