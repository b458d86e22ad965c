#pragma once
// Whether the states after a step are plausible, for each actor by itself. A joint that a tick tore open is closed again: what the joint
// carries is moved to its parent. An actor whose joints are torn tick after tick, or whose state makes no sense, ends: it is put back to
// the state that was published last, stays there and touches nothing, while all others continue.

#include <span>
#include <vector>

#include "world/ode/joints/joint_rows.h"
#include "world/ode/solver/cluster_solver.h"

namespace trundle {

class ActorFaults {
public:
    /// All of these outlive this.
    ActorFaults(OdeObjects& objects, const JointRows& rows, const ClusterSolver& solver)
        : m_objects(objects), m_rows(rows), m_solver(solver) {}

    /// After each step, before its states are published.
    void check();

    [[nodiscard]] std::span<const EngineFault> ended() const { return m_ended; }   ///< one for each actor that ended
    [[nodiscard]] std::span<const EngineFault> closed() const { return m_closed; } ///< the first closed joint of each actor

private:
    [[nodiscard]] Vec3 gapOf(const OdeJoint& joint) const;
    void checkJoints();
    void note(std::uint32_t actor, const EngineFault& fault, bool beyondHelp);
    void closeJoints(std::uint32_t actor);
    void closeLinks(std::uint32_t actor);
    void releaseLinks(std::uint32_t actor);
    void end(std::uint32_t actor, const EngineFault& fault);
    void hold() const;

    /// An actor with a joint that was torn lately.
    struct Torn {
        std::uint32_t actor = 0;
        double ticks = 0; ///< in which it was; earlier ones count less
        bool now = false;
    };
    struct Held {
        std::uint32_t body = 0;
        RawState state;
    };
    OdeObjects& m_objects;
    const JointRows& m_rows;
    const ClusterSolver& m_solver;
    std::vector<Torn> m_torn;
    std::vector<Held> m_held; ///< bodies of actors that ended
    std::vector<EngineFault> m_ended, m_closed;
};

/// The fault of a step that ODE could not finish: names the body with an invalid state, otherwise the lightest one, which is the
/// usual cause.
[[nodiscard]] EngineFault interruptedFault(const OdeObjects& objects);

} // namespace trundle
