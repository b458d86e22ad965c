#include "world/ode/ode_dynamics.h"

#include <algorithm>

namespace trundle {

namespace {

constexpr double kOutside = 1.1; // of a cone's limit: less is not worth another solution
constexpr int kMostCones = 2, kMostVelocities = 3, kMostThrown = 3;

} // namespace

OdeDynamics::OdeDynamics(const EngineSettings& settings, OdeWorld& world, const OdeObjects& objects, TickContacts& contacts)
    : m_settings(settings), m_objects(objects), m_contacts(contacts), m_rows(settings, world, objects), m_stops(objects),
      m_heaps(settings), m_solver(settings, world, objects, contacts, m_rows, m_drift) {}

void OdeDynamics::prepare() {
    if (m_prepared == m_objects.bodies.size()) return;
    m_pinned.start(m_objects.bodies, m_objects.joints, m_settings.gravity);
    m_rotation.start(m_objects.bodies, m_objects.inertias, m_objects.joints, m_pinned);
    m_drift.setUp(m_objects.bodies, m_objects.joints);
    m_plan.setUp(m_objects.bodies, m_objects.joints, m_objects.couplings, m_objects.latches);
    m_impacts.setUp(m_objects.joinedActors());
    m_stops.setUp();
    m_prepared = m_objects.bodies.size();
}

void OdeDynamics::forget(std::uint32_t actor) {
    m_memory.forget(actor);
    m_heaps.forget(m_objects.actors[actor].bodies);
}

void OdeDynamics::step(double h) {
    m_impacts.find(m_contacts.all, m_objects.bodies, m_objects.geoms, m_settings.surfaces);
    m_pinned.before(m_objects.bodies, m_objects.joints, h, m_drift.expectRates(m_objects.bodies));
    m_rotation.before(m_objects.bodies, m_impacts.touching(), h);
    m_drift.start(m_objects.bodies, m_contacts.all);
    solve(h);
    m_pinned.after(m_objects.bodies, h);
    m_rotation.after(m_objects.bodies, h);
    moveAside(h);
}

/// What a contact pushed out.
void OdeDynamics::moveAside(double h) const {
    for (const ClusterSolver::Aside& a : m_solver.aside()) {
        const OdeBody& b = m_objects.bodies[a.body];
        const Vec3 to = vec(b.p) + h * a.linear;
        dReal q[4];
        const Quat turned = turnedBy(h * a.angular);
        const Vec3 rate = m_rotation.turnedAside(b, a.body, turned);
        toOde(turned * quat(b.q), q);
        dBodySetPosition(b.id, to.x(), to.y(), to.z());
        dBodySetQuaternion(b.id, q);
        dBodySetAngularVel(b.id, rate.x(), rate.y(), rate.z());
    }
}

void OdeDynamics::solve(double h) {
    m_plan.make(m_settings.solver, -m_settings.gravity.normalized(), m_contacts.all, m_objects.geoms);
    recordLargest();
    m_memory.recall(m_contacts.all);
    m_rows.startSprings(m_contacts.all, h);
    m_contacts.feedbacks.reserve(m_contacts.all.capacity());
    m_contacts.feedbacks.resize(m_contacts.all.size()); // the solver fills every one; they must stay where they are until it has
    if (m_plan.hasOutside())
        m_heaps.apply(h, m_contacts.all, m_objects.bodies, m_objects.geoms, m_plan.clusters(), m_contacts.feedbacks);
    else m_heaps.skip();
    m_rows.make(m_contacts, h);
    m_solver.step(h, m_plan);
    followCones(h);
    while (m_settings.solver != SolverChoice::Quick &&
           m_impacts.needRepeat(m_contacts.all, m_contacts.feedbacks, m_objects.bodies, m_objects.geoms, m_solver.before())) {
        m_rows.clear();
        m_solver.takeBack(); // rows depend on the velocities
        m_rows.make(m_contacts, h);
        m_solver.stepAgain(h, m_plan);
        followCones(h);
    }
    if (m_settings.solver != SolverChoice::Quick) limitSprings(h);
    if (m_settings.solver != SolverChoice::Quick) keepVelocities(h);
    m_rows.clear();
    keepContacts(h);
}

/// The clusters of these contacts, with their rows made anew, and of these bodies once more.
void OdeDynamics::takeBack(std::span<const std::uint32_t> contacts, double h, std::span<const std::uint32_t> bodies) {
    m_again.assign(bodies.begin(), bodies.end());
    for (const std::uint32_t i : contacts) m_again.push_back(m_objects.geoms[m_contacts.all[i].first].body);
    m_solver.takeBack(m_plan, m_again);
    m_rows.remake(m_contacts, contacts, h);
}

/// Where friction left its cone the solution says what the contact carries and how it slips.
void OdeDynamics::followCones(double h) {
    if (m_settings.solver == SolverChoice::Quick) return;
    for (int again = 0; again < kMostCones; ++again) {
        const auto outside = m_cones.find(m_contacts, m_objects, m_rows, m_solver.before(), kOutside);
        if (outside.empty()) return;
        takeBack(outside, h);
        m_solver.solveTaken(h, m_plan);
    }
}

/// No spring of a surface gives more than it took.
void OdeDynamics::limitSprings(double h) {
    for (int i = 0; i < kMostThrown; ++i) {
        const auto thrown = m_rows.findThrown(m_contacts, m_solver.before(), h);
        if (thrown.empty()) return;
        takeBack(thrown, h);
        m_solver.solveTaken(h, m_plan);
    }
}

/// What a contact or the stop of a joint pushes out is moved, not thrown.
void OdeDynamics::keepVelocities(double h) {
    auto again = m_pushOut.find(m_contacts, m_objects, m_settings.surfaces, m_rows, m_solver.before(), h);
    auto stopped = m_stops.find();
    for (int i = 0; i < kMostVelocities && !(again.empty() && stopped.empty()); ++i) {
        takeBack(again, h, stopped);
        m_solver.solveVelocities(h, m_plan);
        again = m_cones.find(m_contacts, m_objects, m_rows, m_solver.before(), kOutside);
        stopped = {};
    }
    m_stops.release();
}

void OdeDynamics::recordLargest() {
    const bool large = m_plan.largest() > kExactClusterMax;
    if (m_settings.calls) // informed of all contacts where none joins bodies
        m_settings.calls->recordCluster(large ? m_plan.largest() : static_cast<std::uint32_t>(m_contacts.all.size()),
                                        large ? m_plan.largestName() : kNone);
    if (large && m_settings.solver == SolverChoice::Exact)
        m_largestExactCluster = std::max<std::size_t>(m_largestExactCluster, m_plan.largest());
}

/// Remembers what the contacts carried.
void OdeDynamics::keepContacts(double h) {
    m_memory.clear();
    for (std::size_t i = 0; i < m_contacts.all.size(); ++i) {
        const OdeContact& c = m_contacts.all[i];
        m_memory.keep(c, vec(m_contacts.feedbacks[i].f1), h * m_objects.carriedBy(c),
                      m_rows.work(c, m_contacts.feedbacks[i], m_solver.before(), h));
    }
}

} // namespace trundle
