#include "world/ode/contacts/contact_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trundle {

namespace {

constexpr double kAtRest = 1e-4;    // rad/s: what rolls more slowly has no direction of its own
constexpr double kSlope = 1e-6;     // sine of the angle of what is not level
constexpr double kSlipSpeed = 1e-7; // m/s: below it friction's axes are ODE's own choice
constexpr double kQuiet = 0.4;      // share of the limit
constexpr double kLevel = 0.8;      // square of the cosine between normal and gravity
// m/s, of a row across that carries its limit: with less give the wheels of one axle, which cannot move against each other, push each
// other to their limits.
constexpr double kYield = 3e-6;

} // namespace

ContactRows::ContactRows(const EngineSettings& settings, const OdeWorld& world, const OdeObjects& objects)
    : m_settings(settings), m_objects(objects), m_geoms(objects.geoms), m_bodies(objects.bodies), m_world(world.id()),
      m_group(dJointGroupCreate(0)) {}

void ContactRows::make(TickContacts& contacts, double h) {
    contacts.rows.reserve(contacts.all.capacity());
    contacts.rows.assign(contacts.all.size(), nullptr);
    for (std::size_t i = 0; i < contacts.all.size(); ++i) {
        const OdeContact& c = contacts.all[i];
        if (!c.outside && !c.iterated) contacts.rows[i] = add(c, h, m_group.get(), &contacts.feedbacks[i]);
    }
}

void ContactRows::remake(TickContacts& contacts, std::span<const std::uint32_t> which, double h) {
    for (const std::uint32_t i : which) {
        if (contacts.rows[i]) dJointDisable(contacts.rows[i]);
        contacts.rows[i] = add(contacts.all[i], h, m_group.get(), &contacts.feedbacks[i]);
    }
}

void ContactRows::clear() { dJointGroupEmpty(m_group.get()); }

dJointID ContactRows::add(const OdeContact& c, double h, dJointGroupID group, dJointFeedback* feedback) const {
    dContact contact;
    contact.geom = {};
    fillSurface(c, h, contact);
    const dJointID joint = dJointCreateContact(m_world, group, &contact);
    const std::uint32_t other = m_geoms[c.second].body;
    dJointAttach(joint, m_bodies[m_geoms[c.first].body].id, other == kNone ? nullptr : m_bodies[other].id);
    dJointSetFeedback(joint, feedback);
    return joint;
}

void ContactRows::fillSurface(const OdeContact& c, double h, dContact& out) const {
    const OdeGeom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    dSurfaceParameters& s = out.surface;
    std::memset(&s, 0, sizeof s);
    const Vec3 point = c.raised == 0 ? vec(c.position) : Vec3(vec(c.position) - c.raised * m_settings.gravity.normalized());
    for (int k = 0; k < 3; ++k) {
        out.geom.pos[k] = point[k];
        out.geom.normal[k] = c.normal[k];
    }
    out.geom.depth = c.depth;

    fillSpring(c, h, out);
    const FrictionLaw law = frictionLaw(c);
    if (c.bounces) { // a spring would eat the bounce
        s.mode = (s.mode & ~dContactSoftCFM) | dContactMotionN;
        s.motionN = -c.restitutionShare * c.restitution * c.speed;
        out.geom.depth = 0;
    }
    if (!(law.along > 0) && !(law.across > 0)) return;
    const Vec3 speed =
        c.solved ? vec(c.solvedSpeed) : Vec3(m_objects.pointVelocity(g1, point) - m_objects.pointVelocity(g2, point));
    fillFriction(c, law, speed, h, out);
}

/// Where a geom's friction points, and what it is along that and across: the way a wheel rolls, else the geom's x axis (y where x
/// stands upright).
FrictionLaw ContactRows::ownFriction(std::uint32_t index, const Vec3& outward) const {
    const OdeGeom& g = m_geoms[index];
    const SurfaceSpec& s = m_settings.surfaces[g.surface];
    FrictionLaw law{outward, Vec3::Zero(), s.friction, s.friction2.value_or(s.friction)};
    if (!s.friction2) return law;
    if (g.wheel) law.direction = turn(m_bodies[g.body].r, g.axle).cross(outward);
    if (law.direction.squaredNorm() < 0.1) {
        const Mat3 axes = m_objects.axesOf(g);
        const Vec3 axis = std::abs(axes.col(0).dot(outward)) < 0.9 ? axes.col(0) : axes.col(1);
        law.direction = axis - axis.dot(outward) * outward;
    }
    law.direction.normalize();
    const double heading = s.frictionHeading;
    if (heading != 0) law.direction = std::cos(heading) * law.direction + std::sin(heading) * outward.cross(law.direction);
    return law;
}

/// Of the two the smaller, in the direction of the one that has any.
FrictionLaw ContactRows::frictionLaw(const OdeContact& c) const {
    const Vec3 normal = vec(c.normal);
    const SurfaceSpec &s1 = m_settings.surfaces[m_geoms[c.first].surface], &s2 = m_settings.surfaces[m_geoms[c.second].surface];
    const double least = std::min(s1.friction, s2.friction);
    if (c.level) return {normal, normal.cross(m_settings.gravity).normalized(), least, 0};
    if (!s1.friction2 && !s2.friction2) return {normal, Vec3::Zero(), least, least};
    const FrictionLaw a = ownFriction(c.first, normal), b = ownFriction(c.second, -normal);
    const FrictionLaw &own = s1.friction2 ? a : b, &other = s1.friction2 ? b : a;
    const auto reach = [&other](const Vec3& way) { // how far the other's ellipse goes that way
        if (other.direction.squaredNorm() == 0) return other.along;
        return std::hypot(other.along * other.direction.dot(way), other.across * other.direction.cross(other.normal).dot(way));
    };
    return {normal, own.direction, std::min(own.along, reach(own.direction)),
            std::min(own.across, reach(normal.cross(own.direction)))};
}

/// The axis of friction where nothing slips: the way a wheel rolls, what gravity is about to start, any.
Vec3 ContactRows::restAxis(const OdeContact& c, const Vec3& normal, const Vec3& slip, double h) const {
    Vec3 rest = vec(c.slide);
    if (rest.squaredNorm() == 0 && c.ticks == 0) {
        rest = slip;
        if (m_geoms[c.second].body == kNone) rest += h * m_settings.gravity;
    }
    rest -= rest.dot(normal) * normal;
    if (rest.norm() <= kSlipSpeed)
        rest = std::abs(normal.x()) < 0.7 ? Vec3(Vec3::UnitX() - normal.x() * normal) : Vec3(Vec3::UnitY() - normal.y() * normal);
    return rest.normalized();
}

/// Far from its limit on level ground: it needs no cone.
bool ContactRows::restsQuietly(const OdeContact& c, const FrictionLaw& law) const {
    if (c.solved) return false;
    const double limit = kQuiet * law.along * c.load, up = law.normal.dot(m_settings.gravity);
    return law.along == law.across && Vec3::Map(c.grip).squaredNorm() < limit * limit &&
           up * up > kLevel * m_settings.gravity.squaredNorm();
}

/// The cone's two rows, bounded by the load of the same solution (of the quick solver: as it would be without any friction).
void ContactRows::fillFriction(const OdeContact& c, FrictionLaw law, const Vec3& speed, double h, dContact& out) const {
    const OdeGeom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    const Vec3& normal = law.normal;
    Vec3 belt = Vec3::Zero(); // of the second surface, as the first sees it
    if (g1.moves) belt -= m_objects.axesOf(g1) * g1.surfaceVelocity;
    if (g2.moves) belt += m_objects.axesOf(g2) * g2.surfaceVelocity;
    Vec3 slip = speed - belt;
    slip -= slip.dot(normal) * normal;
    const Vec3 rest = restAxis(c, normal, slip, h);
    if (law.direction.squaredNorm() == 0) law.direction = rest;
    const bool exact = !c.iterated && m_settings.solver != SolverChoice::Quick, quiet = exact && restsQuietly(c, law);
    const FrictionState state =
        c.solved ? FrictionState{slip, vec(c.solvedGrip), c.solvedLoad} : FrictionState{slip, vec(c.grip), c.load};
    const FrictionRows rows = quiet ? FrictionRows{rest, law.along, law.across, 0, 0} : frictionRows(law, state, rest);

    dSurfaceParameters& s = out.surface;
    s.mode |= dContactFDir1 | dContactAxisDep | dContactApprox1;
    s.mu = rows.limit;
    s.mu2 = rows.acrossLimit;
    for (int k = 0; k < 3; ++k) out.fdir1[k] = rows.axis[k];
    const double yield =
        exact && state.load > 0 ? std::max(rows.give, kYield / std::max(rows.acrossLimit * state.load, kYield)) : rows.give;
    if (yield > kWorldCfm) { // less would take the place of that, and leave the rows of many contacts singular
        s.mode |= dContactSlip2;
        s.slip2 = yield;
    }
    if (g1.moves || g2.moves || rows.creep != 0) {
        s.mode |= dContactMotion1 | dContactMotion2;
        s.motion1 = belt.dot(rows.axis);
        s.motion2 = belt.dot(normal.cross(rows.axis)) + rows.creep;
    }
    const double rolling =
        std::max(m_settings.surfaces[g1.surface].rollingFriction, m_settings.surfaces[g2.surface].rollingFriction);
    if (rolling > 0) {
        s.mode |= dContactRolling;
        const Vec3 axis = rollingAxis(c, normal);
        const bool known = !axis.isZero(0);
        s.rho = rolling * (known ? std::abs(axis.dot(rows.axis)) : 1);
        s.rho2 = rolling * (known ? std::abs(axis.dot(normal.cross(rows.axis))) : 1);
        s.rhoN = 0;
    }
}

/// What resistance to rolling acts about: the axis that the two bodies roll about, at rest the one that gravity turns them about, zero
/// where there is neither. ODE has a row for each of two axes; their shares of this one make the resistance equal in all directions.
Vec3 ContactRows::rollingAxis(const OdeContact& c, const Vec3& normal) const {
    const std::uint32_t first = m_geoms[c.first].body, second = m_geoms[c.second].body;
    Vec3 spin = vec(m_bodies[first].w);
    if (second != kNone) spin -= vec(m_bodies[second].w);
    spin -= spin.dot(normal) * normal;
    if (spin.norm() > kAtRest) return spin.normalized();
    const Vec3 load = normal.cross(m_settings.gravity);
    return load.norm() > kSlope * m_settings.gravity.norm() ? Vec3(load.normalized()) : Vec3(Vec3::Zero());
}

} // namespace trundle
