#include "world/ode/ode_engine.h"

#include <algorithm>
#include <cmath>

namespace trundle {

Result<std::unique_ptr<Engine>> makeOdeEngine(const EngineSettings& settings) {
    try {
        startOde();
        prepareThread();
        return std::unique_ptr<Engine>(std::make_unique<OdeEngine>(settings));
    } catch (const OdeFault&) { return Error{Code::EngineFault, "the physics engine cannot be started on this machine"}; }
}

OdeEngine::OdeEngine(const EngineSettings& settings) : m_settings(settings) {
    m_world = dWorldCreate();
    m_solver.start(m_world);
    m_contactGroup = dJointGroupCreate(0);
    dWorldSetGravity(m_world, settings.gravity.x(), settings.gravity.y(), settings.gravity.z());
    dWorldSetCFM(m_world, kWorldCfm); // before any joint: joints copy these at birth
    dWorldSetERP(m_world, settings.errorReduction);
    dWorldSetContactMaxCorrectingVel(m_world, dInfinity); // fillSpring has a limit of its own
    dWorldSetContactSurfaceLayer(m_world, 0);
    dWorldSetQuickStepNumIterations(m_world, settings.iterations);
    dWorldSetAutoDisableFlag(m_world, 0);
    m_ray = dCreateRay(nullptr, 1);
    dGeomRaySetClosestHit(m_ray, 1);
}

OdeEngine::~OdeEngine() {
    try {
        for (Geom& g : m_geoms) {
            if (g.id) dGeomDestroy(g.id);
            if (g.asSphere) dGeomDestroy(g.asSphere);
        }
        if (m_ray) dGeomDestroy(m_ray);
        m_geoms.clear();
        dJointGroupDestroy(m_contactGroup);
        dWorldDestroy(m_world);
    } catch (const OdeFault&) { // after a fault some of it may not come apart: better lost than dead
    }
}

void OdeEngine::setMotor(JointHandle joint, const MotorConstraint& row) { m_rows.setMotor(joint.index, row); }
void OdeEngine::addJointTorque(JointHandle joint, double torque) { m_torques.push_back({joint.index, torque}); }
void OdeEngine::addForce(BodyHandle body, const Vec3& force, const Vec3& point) {
    m_forces.push_back({body.index, force, point});
}
void OdeEngine::moveActor(ActorHandle actor, const Pose& motion) { m_motions.push_back({actor.index, motion}); }

/// Nothing between two steps reads them, so they need not wait.
void OdeEngine::setSurface(std::size_t surface, const SurfaceSpec& values) {
    if (surface < m_settings.surfaces.size()) m_settings.surfaces[surface] = values;
}

void OdeEngine::setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) {
    Geom& g = m_geoms[geom.index];
    g.surfaceVelocity = velocity;
    g.moves = velocity.squaredNorm() > 0;
}

void OdeEngine::findContacts() {
    try {
        prepareThread();
        if (!m_staticsDone) finishStatics();
        updateBoxes();
        collide();
    } catch (const OdeFault&) { // contacts found so far stay: a step would say what is wrong
    }
    m_contactFeedbacks.assign(m_contacts.size(), {});
}

std::optional<EngineFault> OdeEngine::step(double h) {
    if (m_fault) return m_fault;
    const std::uint64_t before = odeMessages();
    try {
        prepareThread();
        if (!m_staticsDone) finishStatics();
        if (!m_bodiesDone) finishBodies();
        applyWrites();
        findStepContacts();
        m_rows.update(h, m_contacts, m_geoms, m_settings.errorReduction);
        move(h);
        m_fault = findFault();
        if (!m_fault) m_sweep.run(h);
        if (!m_fault) publish(h);
    } catch (const OdeFault&) {
        m_solver.abandonWorld();
        m_fault = interruptedFault();
    }
    m_solverWarnings += odeMessages() - before;
    return m_fault;
}

void OdeEngine::applyWrites() {
    for (const ActorMotion& motion : m_motions) applyMotion(motion);
    for (const JointTorque& torque : m_torques) applyTorque(torque);
    for (const BodyForce& f : m_forces)
        dBodyAddForceAtPos(m_bodies[f.body].id, f.force.x(), f.force.y(), f.force.z(), f.point.x(), f.point.y(), f.point.z());
    m_motions.clear();
    m_torques.clear();
    m_forces.clear();
}

void OdeEngine::applyTorque(const JointTorque& write) {
    const Joint& j = m_joints[write.joint];
    if (j.type == JointType::Slider) {
        dJointAddSliderForce(j.id, write.torque);
        return;
    }
    const Vec3 torque = write.torque * turn(m_bodies[j.child].r, j.childAxis);
    dBodyAddTorque(m_bodies[j.child].id, torque.x(), torque.y(), torque.z());
    if (j.parent != kNone) dBodyAddTorque(m_bodies[j.parent].id, -torque.x(), -torque.y(), -torque.z());
}

void OdeEngine::applyMotion(const ActorMotion& write) {
    m_memory.forget(write.actor);
    m_heaps.forget(m_actors[write.actor].bodies);
    m_placed.push_back(write.actor);
    for (std::uint32_t i = m_actors[write.actor].bodies.begin; i < m_actors[write.actor].bodies.end; ++i) {
        Body& b = m_bodies[i];
        const Vec3 position = write.motion * vec(b.p);
        dReal q[4];
        toOde((write.motion.rotation * quat(b.q)).normalized(), q);
        dBodySetPosition(b.id, position.x(), position.y(), position.z());
        dBodySetQuaternion(b.id, q);
        dBodySetLinearVel(b.id, 0, 0, 0);
        dBodySetAngularVel(b.id, 0, 0, 0);
    }
    for (std::uint32_t i = m_actors[write.actor].joints.begin; i < m_actors[write.actor].joints.end; ++i)
        m_joints[i].rate = m_joints[i].lastRate = 0;
}

/// The solver between what it does not know of: that inertia turns with its body, and joints with theirs.
void OdeEngine::move(double h) {
    m_impacts.find(m_contacts, m_bodies, m_geoms, m_settings.surfaces);
    m_pinned.before(m_bodies, m_joints, h, m_drift.expectRates(m_bodies));
    m_rotation.before(m_bodies, m_impacts.touching(), h);
    m_drift.start(m_bodies, m_contacts);
    solve(h);
    m_pinned.after(m_bodies);
    m_rotation.after(m_bodies, h);
}

SolverScene OdeEngine::solverScene() {
    return {m_settings,
            m_bodies,
            m_joints,
            m_geoms,
            m_contacts,
            m_contactFeedbacks,
            m_contactRows,
            m_drift,
            [this](const Contact& contact, double h, dJointGroupID group, dJointFeedback* feedback) {
                (void)makeContactJoint(contact, h, group, feedback);
            },
            [this](const Contact& c) {
                return Vec3(pointVelocity(m_geoms[c.first], vec(c.position)) - pointVelocity(m_geoms[c.second], vec(c.position)));
            },
            [this](const Contact& c) { return carriedBy(c); }};
}

void OdeEngine::solve(double h) {
    m_plan.make(m_settings.solver, -m_settings.gravity.normalized(), m_contacts, m_geoms);
    if (m_settings.calls) { // hears of all contacts where none joins bodies
        const bool large = m_plan.largest() > kExactClusterMax;
        m_settings.calls->recordCluster(large ? m_plan.largest() : static_cast<std::uint32_t>(m_contacts.size()),
                                        large ? m_plan.largestName() : 0xffffffffu);
    }
    if (m_plan.largest() > kExactClusterMax)
        m_largestExactCluster = std::max<std::size_t>(m_largestExactCluster, m_plan.largest());
    m_memory.recall(m_contacts);
    m_contactFeedbacks.resize(m_contacts.size()); // the solver fills every one; they must stay where they are until it has
    if (m_plan.hasOutside()) m_heaps.apply(h, m_contacts, m_bodies, m_geoms, m_plan.clusters(), m_contactFeedbacks);
    else m_heaps.skip();
    makeContactJoints(h);
    m_solver.step(h, m_plan);
    while (m_settings.solver != SolverChoice::Quick &&
           m_impacts.needRepeat(m_contacts, m_contactFeedbacks, m_bodies, m_geoms, m_solver.before())) {
        dJointGroupEmpty(m_contactGroup);
        makeContactJoints(h);
        m_solver.stepAgain(h, m_plan);
    }
    dJointGroupEmpty(m_contactGroup);
    keepContacts(h);
}

} // namespace trundle
