#include "world/ode/solver/cluster_solver.h"

#include <algorithm>
#include <cstring>
#include <utility>

#include "base/rng.h"
#include "world/ode/lcp/solve_lcp.h"
#include "world/ode/objects/ode_fault.h"
#include "world/ode/objects/ode_math.h"
#include "world/ode/solver/random_order.h"

namespace trundle {

namespace {

/// Each interrupted step loses the memory that ODE had taken for it (some 10 kB to 1 MB); a cluster that needs more of them is left to
/// the quick solver.
constexpr std::uint32_t kMaxStumbles = 100;
constexpr int kMaxRepeats = 3;
constexpr int kWhipSteps = 8;
constexpr double kWhip = 2e-4; // m that a joint is off
constexpr std::size_t kWorthSharing = 16; // clusters, by all threads

} // namespace

ClusterSolver::ClusterSolver(const EngineSettings& settings, OdeWorld& world, const OdeObjects& objects, TickContacts& contacts,
                             const ContactRows& rows, JointDrift& drift)
    : m_settings(settings), m_world(world), m_objects(objects), m_contacts(contacts), m_drift(drift),
      m_short(world, objects, contacts, rows) {}

void ClusterSolver::step(double h, SolverPlan& plan) {
    m_countedQuick = m_countedRescue = false;
    m_aside.clear();
    run(h, plan);
    ++m_tick;
}

void ClusterSolver::takeBack() const {
    for (std::uint32_t i = 0; i < m_objects.bodies.size(); ++i) restore(i);
}

void ClusterSolver::stepAgain(double h, SolverPlan& plan) {
    --m_tick; // the same random numbers
    run(h, plan);
    ++m_tick;
}

void ClusterSolver::run(double h, SolverPlan& plan) {
    m_rescued = m_swept = false;
    m_quick.clear();
    m_stumbles.resize(m_objects.bodies.size(), 0);
    m_allQuick = m_settings.solver == SolverChoice::Quick;
    if (m_allQuick) stepAllQuickly(h);
    else stepExactly(h, plan);
    if ((m_allQuick || m_swept || !m_quick.empty()) && !std::exchange(m_countedQuick, true)) ++m_quickTicks;
    if (m_rescued && !std::exchange(m_countedRescue, true)) ++m_rescuedTicks;
}

bool ClusterSolver::isQuick(std::uint32_t body) const {
    return m_allQuick || std::binary_search(m_quick.begin(), m_quick.end(), body);
}

/// The same for all that is solved by itself in a tick: who else there is must not matter.
void ClusterSolver::seed() const { seedOrders(randomBits(m_settings.seed, 0, m_tick, 0)); }

void ClusterSolver::stepAllQuickly(double h) {
    seed();
    m_drift.shift(m_objects.bodies, m_objects.joints, m_objects.couplings, h, m_settings.errorReduction);
    m_world.useOneThread(true); // its random numbers are of the thread
    m_world.quickStep(h);
    m_drift.shiftBack(m_objects.bodies);
}

/// One exact step of all that is enabled. False where the solver met a singular row: it reports it and leaves nonsense behind, or fails
/// an assertion in the middle of its work.
bool ClusterSolver::tryExactly(double h) {
    const std::uint64_t before = odeMessages();
    m_drift.shift(m_objects.bodies, m_objects.joints, m_objects.couplings, h, m_settings.errorReduction);
    bool whole = true;
    try {
        m_world.step(h);
    } catch (const OdeFault&) {
        m_world.recover();
        whole = false;
    }
    m_drift.shiftBack(m_objects.bodies);
    return whole && odeMessages() == before;
}

void ClusterSolver::stepExactly(double h, SolverPlan& plan) {
    save();
    m_world.share(m_objects.actors.size() >= kWorthSharing);
    BodyClusters& clusters = plan.clusters();
    m_alone.clear();
    std::ranges::set_union(plan.iterated(), plan.piles(), std::back_inserter(m_alone));
    for (const std::uint32_t name : m_alone)
        for (const std::uint32_t body : clusters.bodies(name)) dBodyDisable(m_objects.bodies[body].id);
    m_anyDisabled = !m_alone.empty();
    if (!tryExactly(h)) {
        plan.findClusters(m_contacts.all, m_objects.geoms);
        m_names.clear();
        std::ranges::set_difference(clusters.all(), m_alone, std::back_inserter(m_names));
        disableAll();
        for (const std::uint32_t name : m_names) restoreCluster(clusters, name);
        stepByThemselves(h, clusters, m_names);
    }
    repeatBent(h, plan);
    for (const std::uint32_t name : m_alone) {
        disableAll();
        if (!std::ranges::binary_search(plan.piles(), name) || !solvePile(h, plan, name)) iterate(h, clusters.bodies(name));
    }
    std::ranges::sort(m_quick);
    if (m_anyDisabled) enableAll();
}

/// Exactly if that is worth it. All bodies are disabled before; after a failure as well, with those of the pile where they were.
bool ClusterSolver::solvePile(double h, SolverPlan& plan, std::uint32_t name) {
    BodyClusters& clusters = plan.clusters();
    const auto putBack = [&] {
        disableAll();
        restoreCluster(clusters, name);
    };
    enableOnly(clusters, std::span(&name, 1));
    if (!plan.isHard(name)) {
        const OnlyQuickIslands quick;
        const bool solved = tryExactly(h) && !quick.gaveUp();
        plan.charge(name, quick.work());
        if (solved) return true;
        plan.markHard(name);
        putBack();
        enableOnly(clusters, std::span(&name, 1));
    }
    const SweptIslands swept(h);
    m_swept = true;
    if (tryExactly(h) && !swept.gaveUp()) return true;
    putBack();
    return false;
}

/// Halves the clusters until those are alone that cannot be solved. All bodies are disabled before and after.
void ClusterSolver::stepByThemselves(double h, BodyClusters& clusters, std::span<const std::uint32_t> names) {
    if (names.size() == 1) return rescue(h, clusters, names[0]);
    const std::size_t half = names.size() / 2;
    for (const auto part : {names.first(half), names.subspan(half)}) {
        if (part.empty()) continue;
        enableOnly(clusters, part);
        const bool solved = tryExactly(h);
        disableAll();
        if (solved) continue;
        for (const std::uint32_t name : part) restoreCluster(clusters, name);
        stepByThemselves(h, clusters, part);
    }
}

/// In a rare tick the exact solver cannot do its work. The cluster is then taken again from the same state with a little more give in
/// every row, and where no give helps by the other solver.
void ClusterSolver::rescue(double h, BodyClusters& clusters, std::uint32_t name) {
    m_rescued = true;
    const auto bodies = clusters.bodies(name);
    bool solved = false;
    for (const double give : {1e2 * kWorldCfm, 1e4 * kWorldCfm}) {
        if (m_stumbles[name] >= kMaxStumbles) break;
        dWorldSetCFM(m_world.id(), give);
        enableOnly(clusters, std::span(&name, 1));
        solved = tryExactly(h);
        disableAll();
        if (solved) break;
        ++m_stumbles[name];
        for (const std::uint32_t body : bodies) restore(body);
    }
    dWorldSetCFM(m_world.id(), kWorldCfm);
    if (!solved) iterate(h, bodies);
}

/// Where bodies turn otherwise than their joints were prepared for, their clusters are taken again, at last in short steps.
void ClusterSolver::repeatBent(double h, SolverPlan& plan) {
    for (int again = 0; again <= kMaxRepeats; ++again) {
        m_drift.findUnexpected(m_objects.bodies, m_objects.joints, h, m_bent, again < kMaxRepeats ? JointDrift::kOpen : kWhip);
        if (m_bent.empty()) return;
        plan.findClusters(m_contacts.all, m_objects.geoms);
        BodyClusters& clusters = plan.clusters();
        for (std::uint32_t& body : m_bent) body = clusters.of(body); // names from here on
        std::ranges::sort(m_bent);
        m_bent.erase(std::unique(m_bent.begin(), m_bent.end()), m_bent.end());
        std::erase_if(m_bent, [&](std::uint32_t name) { return std::ranges::find(m_quick, name) != m_quick.end(); });
        std::erase_if(m_bent, [&](std::uint32_t name) { return std::ranges::binary_search(m_alone, name); }); // not yet solved
        if (again == kMaxRepeats) std::erase_if(m_bent, [&](std::uint32_t name) { return !isPlain(clusters, name); });
        if (m_bent.empty()) return;
        disableAll();
        if (again == kMaxRepeats) {
            for (const std::uint32_t name : m_bent) whip(h, clusters, name);
            return;
        }
        for (const std::uint32_t name : m_bent) {
            m_drift.expect(m_objects.bodies, clusters.bodies(name));
            for (const std::uint32_t body : clusters.bodies(name)) restore(body);
        }
        enableOnly(clusters, m_bent);
        const bool solved = tryExactly(h);
        disableAll();
        if (solved) continue;
        for (const std::uint32_t name : m_bent) restoreCluster(clusters, name);
        stepByThemselves(h, clusters, m_bent);
    }
}

void ClusterSolver::takeBack(SolverPlan& plan, std::span<const std::uint32_t> bodies) {
    plan.findClusters(m_contacts.all, m_objects.geoms);
    BodyClusters& clusters = plan.clusters();
    m_names.clear();
    for (const std::uint32_t body : bodies)
        if (!isQuick(body)) m_names.push_back(clusters.of(body));
    std::ranges::sort(m_names);
    m_names.erase(std::unique(m_names.begin(), m_names.end()), m_names.end());
    m_taken.clear();
    disableAll();
    for (const std::uint32_t name : m_names)
        for (const std::uint32_t body : clusters.bodies(name)) {
            m_taken.emplace_back(body, rawState(m_objects.bodies[body]));
            restore(body);
        }
    enableOnly(clusters, m_names);
}

/// Solves what was taken back, cluster by cluster where it cannot be solved together, and names in m_unsolved those that cannot at all.
void ClusterSolver::solveNames(double h, SolverPlan& plan) {
    const auto isPile = [&](std::uint32_t name) { return std::ranges::binary_search(plan.piles(), name); };
    m_unsolved.clear();
    if (std::ranges::none_of(m_names, isPile) && tryExactly(h)) return;
    disableAll();
    for (const std::uint32_t name : m_names) restoreCluster(plan.clusters(), name);
    for (const std::uint32_t name : m_names) {
        enableOnly(plan.clusters(), std::span(&name, 1));
        const bool solved = isPile(name) ? solvePile(h, plan, name) : tryExactly(h);
        disableAll();
        if (!solved) m_unsolved.push_back(name);
    }
}

void ClusterSolver::solveTaken(double h, SolverPlan& plan) {
    solveNames(h, plan);
    for (const auto& [body, state] : m_taken)
        if (std::ranges::binary_search(m_unsolved, plan.clusters().of(body))) setRawState(m_objects.bodies[body], state);
    enableAll();
}

void ClusterSolver::solveVelocities(double h, SolverPlan& plan) {
    solveNames(h, plan);
    for (const auto& [body, state] : m_taken) {
        const OdeBody& b = m_objects.bodies[body];
        if (std::ranges::binary_search(m_unsolved, plan.clusters().of(body))) setRawState(b, state);
        else m_aside.push_back({body, vec(state.v) - vec(b.v), vec(state.w) - vec(b.w)});
    }
    enableAll();
}

/// Whether its joints have no rows that were prepared for the whole tick.
bool ClusterSolver::isPlain(const BodyClusters& clusters, std::uint32_t name) const {
    const auto isCoupled = [&](const OdeCoupling& coupling) { return clusters.of(coupling.first) == name; };
    if (std::ranges::any_of(m_objects.couplings, isCoupled)) return false;
    return std::ranges::none_of(m_objects.joints, [&](const OdeJoint& joint) {
        const bool prepared = joint.driven || joint.spring || joint.stop || joint.type == JointType::Suspension;
        return prepared && clusters.of(joint.child) == name;
    });
}

/// A chain that whips about, in short steps. All bodies are disabled before and after. Where the exact solver fails the cluster stays as
/// the whole tick left it.
void ClusterSolver::whip(double h, BodyClusters& clusters, std::uint32_t name) {
    const double part = h / kWhipSteps;
    const auto bodies = clusters.bodies(name);
    m_whole.clear();
    for (const std::uint32_t body : bodies) {
        m_whole.push_back(rawState(m_objects.bodies[body]));
        restore(body);
    }
    const auto putBack = [&](const std::vector<RawState>& states) {
        for (std::size_t i = 0; i < bodies.size(); ++i) setRawState(m_objects.bodies[bodies[i]], states[i]);
    };
    enableOnly(clusters, std::span(&name, 1));
    bool solved = true;
    for (int k = 0; k < kWhipSteps && solved; ++k) {
        m_from.clear();
        for (const std::uint32_t body : bodies) {
            m_from.push_back(rawState(m_objects.bodies[body]));
            std::memcpy(m_from.back().force, m_saved[body].force, sizeof m_from.back().force);
            std::memcpy(m_from.back().torque, m_saved[body].torque, sizeof m_from.back().torque);
        }
        for (int again = 0; again <= kMaxRepeats && solved; ++again) {
            m_drift.expect(m_objects.bodies, bodies);
            putBack(m_from);
            solved = tryExactly(part);
            m_drift.findUnexpected(m_objects.bodies, m_objects.joints, part, m_unexpected);
            if (std::ranges::none_of(m_unexpected, [&](std::uint32_t body) { return clusters.of(body) == name; })) break;
        }
    }
    if (!solved) putBack(m_whole);
    disableAll();
}

void ClusterSolver::iterate(double h, std::span<const std::uint32_t> bodies) {
    m_quick.insert(m_quick.end(), bodies.begin(), bodies.end());
    seed();
    m_short.run(h, bodies, m_saved);
}

void ClusterSolver::save() {
    m_saved.resize(m_objects.bodies.size());
    for (std::size_t i = 0; i < m_saved.size(); ++i) m_saved[i] = rawState(m_objects.bodies[i]);
}

void ClusterSolver::restore(std::uint32_t body) const { setRawState(m_objects.bodies[body], m_saved[body]); }

void ClusterSolver::restoreCluster(BodyClusters& clusters, std::uint32_t name) const {
    for (const std::uint32_t body : clusters.bodies(name)) restore(body);
}

void ClusterSolver::enableOnly(BodyClusters& clusters, std::span<const std::uint32_t> names) {
    m_world.share(names.size() >= kWorthSharing);
    for (const std::uint32_t name : names)
        for (const std::uint32_t body : clusters.bodies(name)) dBodyEnable(m_objects.bodies[body].id);
}

void ClusterSolver::disableAll() {
    m_anyDisabled = true;
    for (const OdeBody& body : m_objects.bodies) dBodyDisable(body.id);
}

void ClusterSolver::enableAll() {
    m_anyDisabled = false;
    for (const OdeBody& body : m_objects.bodies) dBodyEnable(body.id);
}

} // namespace trundle
