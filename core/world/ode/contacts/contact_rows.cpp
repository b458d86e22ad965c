#include "world/ode/contacts/contact_rows.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace trundle {

namespace {

constexpr double kAtRest = 1e-4;    // rad/s: what rolls more slowly has no direction of its own, and carries nothing along
constexpr double kSlope = 1e-6;     // sine of the angle of what is not level
constexpr double kSlipSpeed = 1e-7; // m/s: below it friction's axes are ODE's own choice
constexpr double kQuiet = 0.4;      // share of the limit
constexpr double kLevel = 0.8;      // square of the cosine between normal and gravity
// m/s, of a row across that carries its limit: with less give the wheels of one axle, which cannot move against each other, push each
// other to their limits. So do more than three wheels with rollers along their one row; where they speed up in a turn, their directions
// in the middle of a tick are not exactly those expected.
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
    const FrictionLaw law = frictionLaw(c, h);
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
/// stands upright). A wheel's is that of the middle of the tick, since so it moves in the tick: the speeds along that of all wheels of a
/// robot that turns steadily belong together.
FrictionLaw ContactRows::ownFriction(std::uint32_t index, const Vec3& outward, double h) const {
    const OdeGeom& g = m_geoms[index];
    const SurfaceSpec& s = m_settings.surfaces[g.surface];
    FrictionLaw law{outward, Vec3::Zero(), s.friction, s.friction2.value_or(s.friction)};
    if (!s.friction2) return law;
    double heading = s.frictionHeading;
    if (g.wheel) {
        const Vec3 axle = turn(m_bodies[g.body].r, g.axle), spin = vec(m_bodies[g.body].w);
        const double rolling = spin.dot(axle), turned = h / 2 * outward.dot(spin - rolling * axle);
        law.direction = axle.cross(outward);
        law.swing = kYield + std::abs(turned * rolling) * g.radius;
        heading += turned;
    }
    if (law.direction.squaredNorm() < 0.1) {
        const Mat3 axes = m_objects.axesOf(g);
        const Vec3 axis = std::abs(axes.col(0).dot(outward)) < 0.9 ? axes.col(0) : axes.col(1);
        law.direction = axis - axis.dot(outward) * outward;
    }
    law.direction.normalize();
    if (heading != 0) law.direction = std::cos(heading) * law.direction + std::sin(heading) * outward.cross(law.direction);
    return law;
}

/// Of the two the smaller, in the direction of the one that has any.
FrictionLaw ContactRows::frictionLaw(const OdeContact& c, double h) const {
    const Vec3 normal = vec(c.normal);
    const SurfaceSpec &s1 = m_settings.surfaces[m_geoms[c.first].surface], &s2 = m_settings.surfaces[m_geoms[c.second].surface];
    const double least = std::min(s1.friction, s2.friction);
    if (c.level) return {normal, normal.cross(m_settings.gravity).normalized(), least, 0};
    if (!s1.friction2 && !s2.friction2) return {normal, Vec3::Zero(), least, least};
    const FrictionLaw a = ownFriction(c.first, normal, h), b = ownFriction(c.second, -normal, h);
    const FrictionLaw &own = s1.friction2 ? a : b, &other = s1.friction2 ? b : a;
    const auto reach = [&other](const Vec3& way) { // how far the other's ellipse goes that way
        if (other.direction.squaredNorm() == 0) return other.along;
        return std::hypot(other.along * other.direction.dot(way), other.across * other.direction.cross(other.normal).dot(way));
    };
    return {normal, own.direction, std::min(own.along, reach(own.direction)),
            std::min(own.across, reach(normal.cross(own.direction))), own.swing};
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
    const Vec3 rest = restAxis(c, normal, slip, h), carried = carriedAlong(c, normal, h);
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
    if (exact && state.load > 0 && law.along > 0 && law.swing > 0 && isBar(law)) {
        s.mode |= dContactSlip1;
        s.slip1 = std::max(law.swing / (law.along * state.load), kWorldCfm);
    }
    if (g1.moves || g2.moves || rows.creep != 0 || !carried.isZero(0)) {
        s.mode |= dContactMotion1 | dContactMotion2;
        s.motion1 = (belt + carried).dot(rows.axis);
        s.motion2 = (belt + carried).dot(normal.cross(rows.axis)) + rows.creep;
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

/// m/s: the velocity of the first body on the second at the start of a tick with which they do not slip in the mean of the tick.
/// What rides goes along a circle and not along its tangent: the velocity of the one centre against the other turns with the body
/// that carries. That is the one that does not roll; where neither does, the one that turns less.
Vec3 ContactRows::carriedAlong(const OdeContact& c, const Vec3& normal, double h) const {
    const OdeGeom &g1 = m_geoms[c.first], &g2 = m_geoms[c.second];
    if (g2.body == kNone) return Vec3::Zero();
    const OdeBody &b1 = m_bodies[g1.body], &b2 = m_bodies[g2.body];
    const Vec3 w1 = vec(b1.w), w2 = vec(b2.w);
    const bool rolls1 = m_objects.rolls(g1, normal), rolls2 = m_objects.rolls(g2, normal);
    if (rolls1 && rolls2) return Vec3::Zero();
    const Vec3& rate = rolls1 || (!rolls2 && w2.squaredNorm() < w1.squaredNorm()) ? w2 : w1;
    const double half = h / 2 * rate.norm();
    if (half < h / 2 * kAtRest) return Vec3::Zero();
    return h / 2 / (1 + half * half) * rate.cross(vec(b1.v) - vec(b2.v));
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
