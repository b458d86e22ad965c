#pragma once
// Steps the bodies. Everything is solved in one call as long as nothing is wrong, since what hangs together nowhere cannot disturb each
// other there. Where ODE stumbles over one cluster, that cluster is found and taken again by itself; large piles are
// solved row after row, larger ones iterated in short steps. Method: bodies that shall not move are disabled.

#include <span>
#include <vector>

#include "world/ode/joints/joint_drift.h"
#include "world/ode/solver/short_steps.h"
#include "world/ode/solver/solver_plan.h"

namespace trundle {

class ClusterSolver {
public:
    /// All of these outlive this.
    ClusterSolver(const EngineSettings& settings, OdeWorld& world, const OdeObjects& objects, TickContacts& contacts,
                  const ContactRows& rows, JointDrift& drift);

    /// One tick. Contact rows of all but the iterated clusters are there.
    void step(double h, SolverPlan& plan);
    /// The bodies are as they were before the step.
    void takeBack() const;
    /// Then the same tick once more, with contact rows as they are now.
    void stepAgain(double h, SolverPlan& plan);
    /// The clusters of these bodies are as they were before the step, until one of the next two solves them once more, with contact rows
    /// as they are then.
    void takeBack(SolverPlan& plan, std::span<const std::uint32_t> bodies);
    void solveTaken(double h, SolverPlan& plan);
    void solveVelocities(double h, SolverPlan& plan);
    /// Of a body: what it moves faster than its velocity says.
    struct Aside {
        std::uint32_t body;
        Vec3 linear, angular;
    };
    /// What of the motion of this tick was in the solution before that alone.
    [[nodiscard]] std::span<const Aside> aside() const { return m_aside; }
    [[nodiscard]] std::span<const RawState> before() const { return m_saved; } ///< by body: before the last step

    [[nodiscard]] bool isQuick(std::uint32_t body) const;                       ///< in the last step
    [[nodiscard]] std::uint64_t quickTicks() const { return m_quickTicks; }     ///< with anything swept or iterated
    [[nodiscard]] std::uint64_t rescuedTicks() const { return m_rescuedTicks; } ///< with anything rescued

private:
    void run(double h, SolverPlan& plan);
    [[nodiscard]] bool tryExactly(double h);
    void stepAllQuickly(double h);
    void stepExactly(double h, SolverPlan& plan);
    [[nodiscard]] bool solvePile(double h, SolverPlan& plan, std::uint32_t name);
    void solveNames(double h, SolverPlan& plan);
    void stepByThemselves(double h, BodyClusters& clusters, std::span<const std::uint32_t> names);
    void rescue(double h, BodyClusters& clusters, std::uint32_t name);
    void repeatBent(double h, SolverPlan& plan);
    [[nodiscard]] bool isPlain(const BodyClusters& clusters, std::uint32_t name) const;
    void whip(double h, BodyClusters& clusters, std::uint32_t name);
    void iterate(double h, std::span<const std::uint32_t> bodies);
    void seed() const;
    void save();
    void restore(std::uint32_t body) const;
    void restoreCluster(BodyClusters& clusters, std::uint32_t name) const;
    void enableOnly(BodyClusters& clusters, std::span<const std::uint32_t> names);
    void disableAll();
    void enableAll();

    const EngineSettings& m_settings;
    OdeWorld& m_world;
    const OdeObjects& m_objects;
    TickContacts& m_contacts;
    JointDrift& m_drift;
    ShortSteps m_short;
    std::vector<RawState> m_saved;                           ///< before the step, should it have to be taken again
    std::vector<std::uint32_t> m_unexpected;                 ///< bodies
    std::vector<std::uint32_t> m_bent, m_stumbles;           ///< m_stumbles: by body, of clusters that it named
    std::vector<std::pair<std::uint32_t, RawState>> m_taken; ///< bodies, as solved before
    std::vector<Aside> m_aside;
    // Of clusters, by name; m_alone: too large to be solved with the others.
    std::vector<std::uint32_t> m_names, m_alone, m_unsolved;
    std::vector<RawState> m_whole, m_from; ///< of what is whipped: by the whole tick, before a short step
    std::vector<std::uint32_t> m_quick; ///< bodies iterated in this step, sorted
    bool m_rescued = false, m_swept = false, m_allQuick = false, m_anyDisabled = false;
    bool m_countedQuick = false, m_countedRescue = false; ///< in this tick
    std::uint64_t m_tick = 0, m_quickTicks = 0, m_rescuedTicks = 0;
};

} // namespace trundle
