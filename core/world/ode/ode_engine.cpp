#include "world/ode/ode_engine.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace trundle {

namespace {

/// Each interrupted step loses the memory that ODE had taken for it (some 10 kB to 1 MB); a world that needs more of them is left to
/// the quick solver.
constexpr std::uint32_t kMaxInterruptedSteps = 300;
constexpr int kMaxRepeats = 3;

} // namespace

Result<std::unique_ptr<Engine>> makeOdeEngine(const EngineSettings& settings) {
    try {
        startOde();
        prepareThread();
        return std::unique_ptr<Engine>(std::make_unique<OdeEngine>(settings));
    } catch (const OdeFault&) { return Error{Code::EngineFault, "the physics engine cannot be started on this machine"}; }
}

OdeEngine::OdeEngine(const EngineSettings& settings) : m_settings(settings) {
    m_world = dWorldCreate();
    makeThreading();
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

void OdeEngine::makeThreading() {
    m_threading = dThreadingAllocateSelfThreadedImplementation();
    if (m_threading)
        dWorldSetStepThreadingImplementation(m_world, dThreadingImplementationGetFunctions(m_threading), m_threading);
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
        if (!m_threading) return;
        if (m_interrupted) abandon(m_threading); // its list of jobs was left half done, and its destructor would abort over that
        else dThreadingFreeImplementation(m_threading);
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
        ++m_tick;
        m_fault = findFault();
        if (!m_fault) m_sweep.run(h);
        if (!m_fault) publish(h);
    } catch (const OdeFault&) {
        m_interrupted = true;
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

/// One exact step. False where the solver met a singular row: it reports it and leaves nonsense behind, or fails an assertion in the
/// middle of its work.
bool OdeEngine::tryExactStep(double h) {
    const std::uint64_t before = odeMessages();
    try {
        dWorldStep(m_world, h);
    } catch (const OdeFault&) {
        ++m_interruptedSteps;
        abandon(m_threading); // its list of jobs is half done
        makeThreading();
        return false;
    }
    return odeMessages() == before;
}

/// In a rare tick the exact solver cannot do its work. The tick is then taken again from the same state with a little more give in
/// every row. False where no give helped: the state is as before the tick.
bool OdeEngine::stepWithGive(double h, bool& rescued) {
    bool solved = false;
    for (const double give : {kWorldCfm, 1e2 * kWorldCfm, 1e4 * kWorldCfm}) {
        dWorldSetCFM(m_world, give);
        m_drift.shift(m_bodies, m_joints, h, m_settings.errorReduction);
        solved = tryExactStep(h);
        m_drift.shiftBack(m_bodies);
        if (solved) break;
        restoreState();
        rescued = true;
    }
    dWorldSetCFM(m_world, kWorldCfm);
    return solved;
}

/// Where bodies turn otherwise than their joints were prepared for, the tick is taken again.
bool OdeEngine::stepExactly(double h) {
    if (m_interruptedSteps >= kMaxInterruptedSteps) return false;
    saveState();
    bool rescued = false, solved = stepWithGive(h, rescued);
    for (int again = 0; again < kMaxRepeats && solved && !m_drift.asExpected(m_bodies, m_joints, h); ++again) {
        restoreState();
        solved = stepWithGive(h, rescued);
    }
    m_rescuedTicks += rescued;
    return solved;
}

void OdeEngine::stepQuickly(double h) {
    ++m_quickTicks;
    dRandSetSeed(static_cast<unsigned long>(randomBits(m_settings.seed, 0, m_tick, 0) &
                                            0xffffffffu)); // ODE's stream belongs to the process
    m_drift.shift(m_bodies, m_joints, h, m_settings.errorReduction);
    dWorldQuickStep(m_world, h);
    m_drift.shiftBack(m_bodies);
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

void OdeEngine::solve(double h) {
    m_quick = m_settings.solver == SolverChoice::Quick;
    if (m_settings.calls)
        m_settings.calls->recordCluster(static_cast<std::uint32_t>(m_contacts.size()), 0xffffffffu); // all of them
    if (!m_quick && m_contacts.size() > kExactClusterMax) {
        const std::size_t largest = largestCluster();
        if (m_settings.solver == SolverChoice::Auto) m_quick = largest > kExactClusterMax;
        else if (largest > kExactClusterMax) m_largestExactCluster = std::max(m_largestExactCluster, largest);
    }
    m_memory.recall(m_contacts);
    makeContactJoints(h);
    m_quick = m_quick || !stepExactly(h);
    while (!m_quick && m_impacts.needRepeat(m_contacts, m_contactFeedbacks, m_bodies, m_geoms, m_saved)) {
        restoreState();
        dJointGroupEmpty(m_contactGroup);
        makeContactJoints(h);
        m_quick = !stepExactly(h);
    }
    if (m_quick) stepQuickly(h);
    dJointGroupEmpty(m_contactGroup);
    keepContacts(h);
}

} // namespace trundle
