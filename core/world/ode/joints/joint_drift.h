#pragma once
// Keeps joints closed while their bodies turn. ODE moves a body along its velocity and turns it about its centre, so that its
// anchors leave the circle they should stay on, and closes that gap in the next ticks, which takes energy. Here the gap that a tick
// is about to make is known beforehand, from the rates at which the bodies will turn. Method: ODE offers no way to say it, so the
// bodies stand a few micrometres aside while it solves. What touches something stays where it is, as its contacts would feel it.

#include <span>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class JointDrift {
public:
    /// Once all bodies and joints are there.
    void setUp(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints);
    /// The rates at which the bodies will probably turn in this tick. The caller may know better.
    [[nodiscard]] std::span<Vec3> expectRates(std::span<const OdeBody> bodies);
    /// What touches something in this tick.
    void start(std::span<const OdeBody> bodies, std::span<const OdeContact> contacts);
    /// Before and after the solver, of what is enabled; `gain`: share of a gap that the solver closes in a tick.
    void shift(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, std::span<const OdeCoupling> couplings,
               double h, double gain);
    void shiftBack(std::span<const OdeBody> bodies);
    static constexpr double kOpen = 1e-6; ///< m: a joint may be off by so much
    /// After the solver: of each joint that was opened farther than `open`, since bodies turned otherwise than expected, one body.
    void findUnexpected(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints, double h,
                        std::vector<std::uint32_t>& found, double open = kOpen) const;
    /// The rates that these bodies have now.
    void expect(std::span<const OdeBody> bodies, std::span<const std::uint32_t> which);

private:
    [[nodiscard]] bool joinActors(std::span<const OdeBody> bodies, std::span<const OdeJoint> joints);
    struct Edge {
        std::uint32_t joint, from, to; ///< bodies, from the root outwards; kNone: the world
        bool closed = false;           ///< in this tick
        Vec3 childArm = Vec3::Zero(), parentArm = Vec3::Zero(), gap = Vec3::Zero(); ///< world: at its start, and expected (m)
    };
    template <class RateOf>
    [[nodiscard]] Vec3 gapOf(const Edge& edge, const OdeJoint& joint, double h, const RateOf& rateOf) const;

    void holdLevers(std::span<const OdeCoupling> couplings, double h, double gain);
    /// The row of a gear, and its distance without that (m).
    struct Row {
        dJointID id;
        double distance;
    };

    std::vector<Edge> m_edges;
    std::vector<Row> m_rows;
    std::vector<std::uint32_t> m_jointed;       ///< bodies
    std::vector<Vec3> m_last, m_rates, m_aside; ///< by body
    std::vector<bool> m_whole;                  ///< by body: turns by the whole angle, not by its tangent
    std::vector<bool> m_touches;                ///< by group of actors
    std::vector<std::uint32_t> m_groupOf;       ///< by actor: joints between actors join them
};

} // namespace trundle
