#include "world/ode/actor_faults.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace trundle {

namespace {

constexpr double kFarthest = 1e5;    // m
constexpr double kFastest = 200;     // m/s
constexpr double kFastestTurn = 1e4; // rad/s
constexpr double kQuickSlack = 5;    // the quick solver closes joint gaps over several steps
constexpr double kBeyondHelp = 10;   // times the limit of a gap
constexpr double kMostTorn = 5;      // ticks
constexpr double kForget = 0.9;      // per tick

bool within(const dReal* v, double most) { // false for NaN
    return std::abs(v[0]) <= most && std::abs(v[1]) <= most && std::abs(v[2]) <= most &&
           v[0] * v[0] + v[1] * v[1] + v[2] * v[2] <= most * most;
}

bool isFinite(const dReal* v, int count) {
    for (int i = 0; i < count; ++i)
        if (!std::isfinite(v[i])) return false;
    return true;
}

std::string text(const char* format, double value) {
    char buffer[128];
    std::snprintf(buffer, sizeof buffer, format, value);
    return buffer;
}

bool isPlausible(const OdeBody& b) {
    return within(b.p, kFarthest) && within(b.v, kFastest) && within(b.w, kFastestTurn) && isFinite(b.q, 4);
}

EngineFault faultOf(const OdeBody& b, std::uint32_t index) {
    const BodyHandle id{index};
    if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
        return {id, "its state is no longer a number"};
    if (!within(b.v, kFastest)) return {id, text("it moves at %.3g m/s", vec(b.v).norm()) + text(", more than %g m/s", kFastest)};
    if (!within(b.w, kFastestTurn))
        return {id, text("it turns at %.3g rad/s", vec(b.w).norm()) + text(", more than %g rad/s", kFastestTurn)};
    return {id, text("it is farther than %g m from the origin", kFarthest)};
}

} // namespace

void ActorFaults::check() {
    for (std::uint32_t i = 0; i < m_objects.bodies.size(); ++i)
        if (const OdeBody& b = m_objects.bodies[i]; !isPlausible(b) && !m_objects.actors[b.actor].ended)
            end(b.actor, faultOf(b, i));
    checkJoints();
    hold();
}

void ActorFaults::checkJoints() {
    for (const OdeJoint& joint : m_objects.joints) {
        if (joint.type == JointType::Slider || joint.type == JointType::Fixed) continue;
        const std::uint32_t actor = m_objects.bodies[joint.child].actor;
        const double open = gapOf(joint).norm(), limit = (m_solver.isQuick(joint.child) ? kQuickSlack : 1) * joint.gapLimit;
        if (!(open > limit) || m_objects.actors[actor].ended) continue;
        if (joint.parent != kNone && m_objects.actors[m_objects.bodies[joint.parent].actor].ended) continue; // it holds no more
        note(actor, {{joint.child}, text("its joint is torn open by %.3g mm", 1e3 * open)}, open > kBeyondHelp * limit);
    }
    for (Torn& torn : m_torn) {
        if (torn.now && !m_objects.actors[torn.actor].ended) closeJoints(torn.actor);
        torn.now = false;
        torn.ticks *= kForget;
    }
    std::erase_if(m_torn, [this](const Torn& t) { return t.ticks < 0.5 || m_objects.actors[t.actor].ended; });
}

void ActorFaults::note(std::uint32_t actor, const EngineFault& fault, bool beyondHelp) {
    auto torn = std::ranges::find(m_torn, actor, &Torn::actor);
    if (torn == m_torn.end()) torn = m_torn.insert(torn, {actor, 0, false});
    if (!std::exchange(torn->now, true)) torn->ticks += 1;
    if (beyondHelp || torn->ticks > kMostTorn) return end(actor, fault);
    const auto isOfActor = [&](const EngineFault& f) { return m_objects.bodies[f.body.index].actor == actor; };
    if (std::ranges::none_of(m_closed, isOfActor)) m_closed.push_back(fault);
}

/// From the parent's anchor to the child's, without what a suspension leaves free.
Vec3 ActorFaults::gapOf(const OdeJoint& joint) const {
    const Vec3 gap = m_rows.anchorGap(joint);
    if (joint.type != JointType::Suspension) return gap;
    const Vec3 axis = turn(m_objects.bodies[joint.parent].r, joint.slideAxis);
    return gap - gap.dot(axis) * axis;
}

/// Outwards from the world or else the first body; what closes a loop of joints stays as it is.
void ActorFaults::closeJoints(std::uint32_t index) {
    const OdeActor& actor = m_objects.actors[index];
    const std::span joints(m_objects.joints.data() + actor.joints.begin, actor.joints.end - actor.joints.begin);
    std::vector<bool> reached(actor.bodies.end - actor.bodies.begin, false);
    const auto isReached = [&](std::uint32_t body) { return body == kNone || reached[body - actor.bodies.begin]; };
    const auto isFixedToWorld = [](const OdeJoint& joint) { return joint.parent == kNone; };
    if (std::ranges::none_of(joints, isFixedToWorld)) reached[0] = true;
    for (bool more = true; more;) {
        more = false;
        for (const OdeJoint& joint : joints) {
            if (isReached(joint.child) == isReached(joint.parent)) continue;
            const bool outwards = isReached(joint.parent);
            const std::uint32_t moved = outwards ? joint.child : joint.parent;
            const bool pins = joint.type != JointType::Slider && joint.type != JointType::Fixed;
            const OdeBody& body = m_objects.bodies[moved];
            const Vec3 to = vec(body.p) + (outwards ? -1 : 1) * (pins ? gapOf(joint) : Vec3(Vec3::Zero()));
            dBodySetPosition(body.id, to.x(), to.y(), to.z());
            reached[moved - actor.bodies.begin] = more = true;
        }
    }
    closeLinks(index);
}

/// Carries the whole actor to what it is joined to.
void ActorFaults::closeLinks(std::uint32_t index) {
    const OdeActor& actor = m_objects.actors[index];
    for (const std::uint32_t link : m_objects.links) {
        const OdeJoint& joint = m_objects.joints[link];
        if (m_objects.bodies[joint.child].actor != index || joint.type == JointType::Slider || joint.type == JointType::Fixed)
            continue;
        const Vec3 gap = gapOf(joint);
        for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) {
            const Vec3 to = vec(m_objects.bodies[i].p) - gap;
            dBodySetPosition(m_objects.bodies[i].id, to.x(), to.y(), to.z());
        }
    }
}

/// Joints and springs to other actors hold no more.
void ActorFaults::releaseLinks(std::uint32_t index) {
    const auto isOfActor = [&](std::uint32_t body) { return body != kNone && m_objects.bodies[body].actor == index; };
    for (OdeCoupling& c : m_objects.couplings)
        if (isOfActor(c.first) != isOfActor(c.second)) {
            c.released = true;
            *c.feedback = {};
            dJointDisable(c.id);
        }
    for (const std::uint32_t link : m_objects.links) {
        OdeJoint& joint = m_objects.joints[link];
        if (!isOfActor(joint.parent) && !isOfActor(joint.child)) continue;
        joint.rate = 0;
        for (const dJointID id : {joint.id, joint.drive, joint.spring, joint.friction, joint.stop, joint.damper, joint.losses})
            if (id) dJointDisable(id);
        for (const auto& rotor : joint.rotors) dJointDisable(rotor->row);
    }
}

/// A body without a mass for the solver, which leaves out its joints too.
void ActorFaults::end(std::uint32_t index, const EngineFault& fault) {
    OdeActor& actor = m_objects.actors[index];
    actor.ended = true;
    m_ended.push_back(fault);
    for (std::uint32_t i = actor.bodies.begin; i < actor.bodies.end; ++i) {
        const OdeBody& body = m_objects.bodies[i];
        const BodyState& s = m_objects.states[i];
        const Vec3 centre = s.position + s.rotation * body.centre;
        dReal q[4];
        toOde(s.rotation, q);
        dBodySetPosition(body.id, centre.x(), centre.y(), centre.z());
        dBodySetQuaternion(body.id, q);
        dBodySetLinearVel(body.id, 0, 0, 0);
        dBodySetAngularVel(body.id, 0, 0, 0);
        dBodySetForce(body.id, 0, 0, 0);
        dBodySetTorque(body.id, 0, 0, 0);
        dBodySetKinematic(body.id);
        m_held.push_back({i, rawState(body)});
    }
    for (std::uint32_t i = actor.joints.begin; i < actor.joints.end; ++i) m_objects.joints[i].rate = 0;
    releaseLinks(index);
}

/// Whatever else turns and moves bodies.
void ActorFaults::hold() const {
    for (const Held& held : m_held) setRawState(m_objects.bodies[held.body], held.state);
}

EngineFault interruptedFault(const OdeObjects& objects) {
    std::uint32_t lightest = 0;
    dReal least = HUGE_VAL;
    for (std::uint32_t i = 0; i < objects.bodies.size(); ++i) {
        const OdeBody& b = objects.bodies[i];
        if (!isFinite(b.p, 3) || !isFinite(b.q, 4) || !isFinite(b.v, 3) || !isFinite(b.w, 3))
            return {{i}, "its state is no longer a number"};
        dMass mass;
        dBodyGetMass(b.id, &mass);
        if (mass.mass >= least) continue;
        least = mass.mass;
        lightest = i;
    }
    return {{lightest}, "the solver finds no valid forces for it"};
}

} // namespace trundle
