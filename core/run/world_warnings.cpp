#include "run/world_warnings.h"

#include "run/schedule.h"
#include "schema/value_words.h"
#include "world/engine.h"

namespace trundle {
namespace {

Diagnostic warningOf(Code code, std::string message, SourceRange range) {
    return {Severity::Warning, code, std::move(message), range, {}, {}, {}};
}

/// The exact solver's time grows with the cube of the number of connected contacts: for the user who selected it.
Diagnostic clusterWarning(const World& world, const std::string& time) {
    const SourceRange range = world.experiment().settings.solverRange;
    Diagnostic d = warningOf(Code::BigCluster,
                             "at t = " + time + " s " + std::to_string(world.solves().largestExactCluster) +
                                 " contacts hang together; Solver = exact gets very slow with so many, auto takes the quick "
                                 "solver then",
                             range);
    if (range.known()) d.fixes.push_back({"auto", {{range, "auto"}}});
    return d;
}

/// For the user who takes Solver = auto to be exact for all.
Diagnostic pileWarning(const World& world, const std::string& time) {
    return warningOf(
        Code::BigCluster,
        "at t = " + time + " s more than " + std::to_string(kExactClusterMax) +
            " contacts hang together in a pile that is too large or too tangled for the exact solver: it is iterated "
            "and less exact than the rest, which stays exact. Solver = exact is slow for such piles",
        world.experiment().settings.solverRange);
}

} // namespace

void WorldWarnings::update(const World& world, std::vector<Diagnostic>& warnings) {
    const std::string tick = numberText(world.experiment().settings.tick),
                      time = numberText(tickTime(world.ticks(), world.experiment().settings.tick));
    if (!m_cluster && world.solves().largestExactCluster > 0) warnings.push_back(clusterWarning(world, time));
    m_cluster = world.solves().largestExactCluster > 0;
    const bool quick =
        world.experiment().settings.solver == SolverChoice::Auto && world.solves().quickTicks > world.solves().rescuedTicks;
    if (!m_pile && quick) warnings.push_back(pileWarning(world, time));
    m_pile = m_pile || quick;
    const SweepReport sweeps = world.sweeps();
    for (; m_passages < sweeps.passed.size(); ++m_passages) {
        const auto& [first, second] = sweeps.passed[m_passages];
        warnings.push_back(warningOf(Code::PassedThrough,
                                     "at t = " + time + " s " + first + " passed through " + second +
                                         ": fast bodies stop at the scenery, but not at each other. A Tick below " + tick +
                                         " s or larger bodies help",
                                     {}));
    }
    const auto timeOf = [&](const Fault& fault) {
        return numberText(nearestTickTime(fault.time, world.experiment().settings.tick));
    };
    for (; m_closedJoints < world.robotFaults().closedJoints.size(); ++m_closedJoints) {
        const Fault& fault = world.robotFaults().closedJoints[m_closedJoints];
        warnings.push_back(warningOf(Code::BlowUp,
                                     fault.body + " at t = " + timeOf(fault) + " s: " + fault.reason +
                                         " and was closed again; a Tick below " + tick + " s keeps it closed",
                                     fault.range));
    }
    for (; m_ends < world.robotFaults().ends.size(); ++m_ends) {
        const auto& [robot, fault] = world.robotFaults().ends[m_ends];
        if (world.fault() && world.fault()->body == fault.body) continue; // it ends the run, which says so
        warnings.push_back(warningOf(Code::BlowUp,
                                     world.experiment().robots[robot].name + " has ended" +
                                         (world.fault() ? "" : ", all others continue") + ": at t = " + timeOf(fault) + " s " +
                                         fault.body + " stopped: " + fault.reason,
                                     fault.range));
        warnings.back().robot = robot;
    }
}

} // namespace trundle
