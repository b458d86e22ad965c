#include "world/ode/ode_engine.h"

namespace trundle {

Result<std::unique_ptr<Engine>> makeOdeEngine(const EngineSettings& settings) {
    try {
        startOde();
        prepareThread();
        return std::unique_ptr<Engine>(std::make_unique<OdeEngine>(settings));
    } catch (const OdeFault&) { return Error{Code::EngineFault, "the physics engine cannot be started on this machine"}; }
}

Result<ActorHandles> OdeEngine::addActor(const ActorDef& actor) {
    m_rays.markMoved();
    return m_builder.addActor(actor);
}

Result<GeomHandle> OdeEngine::addStatic(const GeomSpec& geom, const Pose& pose) {
    m_rays.markMoved();
    auto added = m_builder.addStatic(geom, pose);
    if (added) m_sweep.addScenery(m_objects.geoms[added.value().index]);
    return added;
}

/// Nothing between two steps reads them, so they need not wait.
void OdeEngine::setSurface(std::size_t surface, const SurfaceSpec& values) {
    if (surface < m_settings.surfaces.size()) m_settings.surfaces[surface] = values;
}

void OdeEngine::setSurfaceVelocity(GeomHandle geom, const Vec3& velocity) {
    OdeGeom& g = m_objects.geoms[geom.index];
    g.surfaceVelocity = g.written.cwiseProduct(velocity);
    g.moves = velocity.squaredNorm() > 0;
}

Status OdeEngine::addAxialInertia(JointHandle id, double inertia) {
    const OdeJoint& joint = m_objects.joints[id.index];
    return trundle::addAxialInertia(joint, m_objects.bodies[joint.child], inertia);
}

/// The world does not turn against a rotor.
Status OdeEngine::addRotor(JointHandle id, double inertia, double ratio) {
    if (m_objects.joints[id.index].parent == kNone) return addAxialInertia(id, ratio * ratio * inertia);
    return m_rotors.add(id.index, inertia, ratio);
}

Status OdeEngine::measureWrench(JointHandle joint) {
    m_wrenches.add(joint.index);
    return {};
}

EngineSolves OdeEngine::solves() const {
    return {m_dynamics.solver().quickTicks(), m_dynamics.solver().rescuedTicks(), m_dynamics.largestExactCluster()};
}

void OdeEngine::findContacts() {
    try {
        prepareThread();
        m_search.find(m_contacts.all);
    } catch (const OdeFault&) { // contacts found so far stay: a step would say what is wrong
    }
    m_contacts.feedbacks.assign(m_contacts.all.size(), {});
}

std::optional<EngineFault> OdeEngine::step(double h) {
    if (m_fault) return m_fault;
    m_rays.markMoved();
    try {
        prepareThread();
        m_dynamics.prepare();
        applyWrites();
        if (m_links.latches().update()) {
            m_dynamics.prepareAgain();
            m_dynamics.prepare();
        }
        m_search.findForStep(m_contacts.all);
        m_rows.update(h, m_contacts.all, m_objects.geoms, m_settings.errorReduction);
        m_rotors.update(h);
        m_wrenches.prepare();
        m_couplings.update(h, m_contacts.all, m_settings.errorReduction);
        m_dynamics.step(h);
        const std::size_t ended = m_faults.ended().size();
        m_faults.check();
        for (const EngineFault& fault : m_faults.ended().subspan(ended)) {
            m_dynamics.forget(m_objects.bodies[fault.body.index].actor);
            m_links.latches().releaseActor(m_objects.bodies[fault.body.index].actor);
        }
        m_sweep.run(h, m_contacts.all);
        publish(h);
    } catch (const OdeFault&) {
        m_world.abandonThreading();
        m_fault = interruptedFault(m_objects);
    }
    return m_fault;
}

void OdeEngine::applyWrites() {
    for (const std::uint32_t moved : m_writes.apply(m_objects)) {
        m_dynamics.forget(moved);
        m_links.latches().releaseActor(moved);
        m_search.markPlaced(moved);
    }
}

void OdeEngine::publish(double h) {
    for (std::uint32_t i = 0; i < m_objects.bodies.size(); ++i) m_objects.publish(i);
    m_joints.resize(m_objects.joints.size());
    for (std::size_t i = 0; i < m_joints.size(); ++i) {
        OdeJoint& joint = m_objects.joints[i];
        m_rows.measure(joint, h);
        if (joint.type != JointType::Ball) // that has an angle of its own, to the stop of its cone
            m_joints[i] = {joint.position, joint.rate, joint.position2, joint.rate2, joint.effort, joint.frictionEffort};
    }
    m_couplings.measure();
    m_byGeom.clear();
}

EngineContact OdeEngine::contact(std::size_t index) const {
    const OdeContact& c = m_contacts.all[index];
    EngineContact out{c.actor, c.partner, c.first, c.second, vec(c.position), vec(c.normal), c.depth, 0, Vec3::Zero()};
    const Vec3 force = vec(m_contacts.feedbacks[index].f1);
    out.force = force.dot(out.normal);
    out.friction = force - out.force * out.normal;
    return out;
}

std::span<const std::uint32_t> OdeEngine::contactsOf(GeomHandle geom) const {
    return m_byGeom.of(geom.index, m_objects.geoms.size(), m_contacts.all);
}

} // namespace trundle
