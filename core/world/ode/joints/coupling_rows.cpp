#include "world/ode/joints/coupling_rows.h"

#include <algorithm>
#include <cmath>

#include "model/gear_line.h"
#include "world/ode/objects/ode_math.h"
#include "world/spring_row.h"

namespace trundle {

namespace {

constexpr double kGain = 1e-9; // of ODE's own correction of a spring's length
constexpr double kApart = OdeCoupling::kApart;
constexpr double kLeastSpringGive = 1e-9;         // N s/m
constexpr double kShort = 1e-9;             // m: a spring without a direction
constexpr std::uint32_t kSpringInertiaTicks = 16; // as for springs of joints

/// Attaches a row along a line between the two bodies.
void attach(OdeCoupling& c, const std::vector<OdeBody>& bodies) {
    const dWorldID world = dBodyGetWorld(bodies[c.first].id);
    c.id = c.isTorque ? dJointCreateAMotor(world, nullptr) : dJointCreateDBall(world, nullptr);
    dJointAttach(c.id, bodies[c.first].id, c.second == kNone ? nullptr : bodies[c.second].id);
    c.feedback = std::make_unique<dJointFeedback>();
    *c.feedback = {};
    dJointSetFeedback(c.id, c.feedback.get());
}

/// Has a force's row reach a rate (m/s) in a step, along its direction through a point. ODE allows no negative distance, so its ends are
/// on the side where they are to part. `gain`: of ODE's own correction.
void setRow(OdeCoupling& c, const Vec3& point, double rate, double h, double gain) {
    c.side = rate < 0 ? -1 : 1;
    const Vec3 end = point + c.side * kApart * c.direction;
    dJointSetDBallAnchor1(c.id, end.x(), end.y(), end.z());
    dJointSetDBallAnchor2(c.id, point.x(), point.y(), point.z());
    c.shift = std::abs(rate) * h / gain;
    dJointSetDBallDistance(c.id, kApart + c.shift);
}

JointLine lineOf(const OdeJoint& joint, const Vec3& anchor, const Vec3& axis) {
    return {joint.type == JointType::Slider, anchor, axis};
}

} // namespace

std::vector<CouplingHandle> CouplingRows::add(const ActorDef& def, std::uint32_t actor) {
    std::vector<CouplingHandle> handles;
    const std::uint32_t first = m_objects.actors[actor].bodies.begin;
    const auto bodyOf = [&](int body) { return body == kWorldBody ? kNone : first + static_cast<std::uint32_t>(body); };
    if (def.springs)
        for (const SpringSpec& spec : *def.springs)
            handles.push_back(keep(springOf(spec, def.frame, bodyOf(spec.child), bodyOf(spec.parent))));
    if (def.gears)
        for (const GearSpec& spec : *def.gears) handles.push_back(keep(gearOf(spec, def, m_objects.actors[actor].joints.begin)));
    return handles;
}

CouplingHandle CouplingRows::addLink(const SpringSpec& spec, std::uint32_t child, std::uint32_t parent) {
    return keep(springOf(spec, Pose{}, child, parent));
}

CouplingHandle CouplingRows::keep(OdeCoupling coupling) {
    for (const std::uint32_t body : {coupling.first, coupling.second})
        if (body != kNone) {
            m_objects.bodies[body].coupled = true;
            if (!coupling.isGear) m_objects.actors[m_objects.bodies[body].actor].sprung = true;
        }
    m_objects.couplings.push_back(std::move(coupling));
    return {static_cast<std::uint32_t>(m_objects.couplings.size() - 1)};
}

OdeCoupling CouplingRows::springOf(const SpringSpec& spec, const Pose& frame, std::uint32_t child, std::uint32_t parent) const {
    OdeCoupling spring;
    spring.first = child;
    spring.second = parent;
    const Vec3 first = frame * spec.anchor2, second = frame * spec.anchor;
    const auto inBody = [&](std::uint32_t body, const Vec3& point) {
        return body == kNone ? point : turnBack(m_objects.bodies[body].r, point - vec(m_objects.bodies[body].p));
    };
    spring.firstAnchor = inBody(spring.first, first);
    spring.secondAnchor = inBody(spring.second, second);
    spring.stiffness = spec.stiffness;
    spring.damping = spec.damping;
    spring.restLength = spec.length;
    spring.around = m_inertias.around(spring.first, spring.second);
    attach(spring, m_objects.bodies);
    dJointSetDBallParam(spring.id, dParamERP, kGain);
    spring.state.length = (first - second).norm();
    return spring;
}

/// The line of a gear is fixed in the body that both joints have in common, as their axes are.
OdeCoupling CouplingRows::gearOf(const GearSpec& spec, const ActorDef& def, std::uint32_t firstJoint) const {
    OdeCoupling gear;
    gear.isGear = true;
    gear.joint = firstJoint + static_cast<std::uint32_t>(spec.joint);
    gear.other = firstJoint + static_cast<std::uint32_t>(spec.other);
    gear.ratio = spec.ratio;
    const OdeJoint &joint = m_objects.joints[gear.joint], &other = m_objects.joints[gear.other];
    const auto index = [](std::uint32_t body) { return body == kNone ? kWorldBody : static_cast<int>(body); };
    const auto ends = gearEnds(index(joint.parent), index(joint.child), index(other.parent), index(other.child));
    const JointSpec &jointSpec = (*def.joints)[static_cast<std::size_t>(spec.joint)],
                    &otherSpec = (*def.joints)[static_cast<std::size_t>(spec.other)];
    const auto worldLine = [&](const OdeJoint& j, const JointSpec& s) {
        return lineOf(j, def.frame * s.anchor, def.frame.rotation * s.axis);
    };
    const auto line = gearLine(worldLine(joint, jointSpec), worldLine(other, otherSpec),
                               spec.ratio * ends->firstSense * ends->secondSense); // checked with the experiment
    gear.isTorque = line->isTorque;
    gear.lever = line->lever * ends->firstSense;
    int first = ends->first, second = ends->second;
    if (first == kWorldBody) {
        std::swap(first, second);
        gear.lever = -gear.lever;
    }
    gear.first = static_cast<std::uint32_t>(first);
    gear.second = second == kWorldBody ? kNone : static_cast<std::uint32_t>(second);
    gear.common = ends->firstSense > 0 ? joint.parent : joint.child;
    gear.point = line->point;
    gear.line = line->direction;
    if (gear.common != kNone) {
        const OdeBody& body = m_objects.bodies[gear.common];
        gear.point = turnBack(body.r, line->point - vec(body.p));
        gear.line = turnBack(body.r, line->direction);
    }
    for (const OdeJoint* geared : {&joint, &other}) // so that angles are the integrals of rates, as those of wheels
        if (geared->type == JointType::Hinge) dBodySetFiniteRotationMode(m_objects.bodies[geared->child].id, 1);
    attach(gear, m_objects.bodies);
    if (gear.isTorque) {
        dJointSetAMotorNumAxes(gear.id, 1);
        dJointSetAMotorParam(gear.id, dParamFMax, dInfinity);
    }
    return gear;
}

Vec3 CouplingRows::pointOf(std::uint32_t body, const Vec3& place) const {
    return body == kNone ? place : Vec3(vec(m_objects.bodies[body].p) + turn(m_objects.bodies[body].r, place));
}

Vec3 CouplingRows::speedOf(std::uint32_t body, const Vec3& point) const {
    if (body == kNone) return Vec3::Zero();
    const OdeBody& b = m_objects.bodies[body];
    return vec(b.v) + vec(b.w).cross(point - vec(b.p));
}

void CouplingRows::update(double h, std::span<const OdeContact> contacts, double errorReduction) {
    for (std::uint32_t i = 0; i < m_objects.couplings.size(); ++i) {
        OdeCoupling& c = m_objects.couplings[i];
        if (c.released || m_objects.actors[m_objects.bodies[c.first].actor].ended) continue;
        if (c.isGear) updateGear(c, h, errorReduction);
        else {
            updateInertia(c, i, contacts);
            updateSpring(c, h);
        }
    }
    ++m_ticks;
}

/// The inertia follows at once what stands on the ground and what does not; poses it follows slowly.
void CouplingRows::updateInertia(OdeCoupling& spring, std::uint32_t index, std::span<const OdeContact> contacts) {
    m_touched.assign(spring.around.size(), false);
    m_pushes.clear();
    for (const OdeContact& c : contacts) {
        if (m_objects.geoms[c.second].body != kNone) continue;
        const auto body = std::ranges::lower_bound(spring.around, m_objects.geoms[c.first].body);
        if (body == spring.around.end() || *body != m_objects.geoms[c.first].body) continue;
        m_touched[static_cast<std::size_t>(body - spring.around.begin())] = true;
        m_pushes.push_back({*body, vec(c.position), vec(c.normal)});
    }
    if (spring.inertia > 0 && m_touched == spring.touched && (m_ticks + index) % kSpringInertiaTicks != 0) return;
    const Vec3 first = pointOf(spring.first, spring.firstAnchor), second = pointOf(spring.second, spring.secondAnchor);
    const Vec3 apart = first - second;
    const Vec3 way = apart.norm() > kShort ? Vec3(apart.normalized()) : Vec3(Vec3::UnitZ());
    const JointInertias::Push pair[] = {{spring.first, first, way}, {spring.second, second, way}};
    spring.inertia = m_inertias.between(spring.around, std::span(pair, spring.second == kNone ? 1 : 2), m_pushes);
    spring.touched = m_touched;
}

void CouplingRows::updateSpring(OdeCoupling& spring, double h) const {
    const Vec3 first = pointOf(spring.first, spring.firstAnchor), second = pointOf(spring.second, spring.secondAnchor);
    const Vec3 apart = first - second;
    const double length = apart.norm();
    if (length > kShort) spring.direction = apart / length;
    const double rate = spring.direction.dot(speedOf(spring.first, first) - speedOf(spring.second, second));
    const SpringRow row = springRow(spring.stiffness, spring.damping, spring.inertia, h);
    const double give = std::max(row.give, kLeastSpringGive);
    setRow(spring, second, -(spring.stiffness * (length - spring.restLength) + row.carry * rate) / give, h, kGain);
    dJointSetDBallParam(spring.id, dParamCFM, 1 / give);
}

void CouplingRows::updateGear(OdeCoupling& gear, double h, double errorReduction) const {
    const OdeJoint &joint = m_objects.joints[gear.joint], &other = m_objects.joints[gear.other];
    const double rate = -errorReduction / h * gear.lever * (joint.position - gear.ratio * other.position);
    gear.direction = gear.common == kNone ? gear.line : turn(m_objects.bodies[gear.common].r, gear.line);
    if (gear.isTorque) {
        dJointSetAMotorAxis(gear.id, 0, 0, gear.direction.x(), gear.direction.y(), gear.direction.z());
        dJointSetAMotorParam(gear.id, dParamVel, rate);
        return;
    }
    // ODE corrects it as it does joints, for which JointDrift puts the bodies aside: that is no motion of the gear.
    dJointSetDBallParam(gear.id, dParamERP, errorReduction);
    setRow(gear, pointOf(gear.common, gear.point), rate, h, errorReduction);
}

void CouplingRows::measure() {
    for (OdeCoupling& c : m_objects.couplings) {
        const double along = c.direction.dot(vec(c.isTorque ? c.feedback->t1 : c.feedback->f1));
        if (c.isGear) {
            c.state.effort = along * c.lever;
            continue;
        }
        const Vec3 first = pointOf(c.first, c.firstAnchor), second = pointOf(c.second, c.secondAnchor), apart = first - second;
        const double length = apart.norm();
        const Vec3 way = length > kShort ? Vec3(apart / length) : c.direction;
        c.state = {length, way.dot(speedOf(c.first, first) - speedOf(c.second, second)), -along};
    }
}

} // namespace trundle
