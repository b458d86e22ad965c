#pragma once
// The inertia that a joint's motor or spring moves: articulated bodies on both sides of the joint, all other joints without effort.
// Contacts are not part of it, so the real inertia may be larger, never smaller.

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class JointInertias {
public:
    JointInertias(const std::vector<OdeBody>& bodies, const std::vector<OdeJoint>& joints) : m_bodies(bodies), m_joints(joints) {}

    /// To be called for each joint once it is complete.
    void add(std::uint32_t joint);
    /// Those of bodies that are gone.
    void forgetRemoved() { m_jointsOf.resize(std::min(m_jointsOf.size(), m_bodies.size())); }
    /// Writes the joint's `inertia` for the current poses.
    void update(OdeJoint& joint, std::uint32_t index);

    /// The bodies that a force between these two may move by joints, with both; kNone: the world.
    [[nodiscard]] std::vector<std::uint32_t> around(std::uint32_t first, std::uint32_t second) const;
    /// A push on a body along a line, or the line of a contact with what does not move.
    struct Push {
        std::uint32_t body;
        Vec3 point, direction;
    };
    /// The inertia (kg) that a force and its reaction move, of `bodies` alone: huge where nothing can move.
    [[nodiscard]] double between(std::span<const std::uint32_t> bodies, std::span<const Push> pair, std::span<const Push> contacts);

private:
    using Vec6 = Eigen::Matrix<double, 6, 1>;
    using Mat6 = Eigen::Matrix<double, 6, 6>;
    using Axes = Eigen::Matrix<double, 6, Eigen::Dynamic, 0, 6, 3>;

    /// Of a motion x + A q of the body on one side of a joint, which has A for its axes, while that on the other side moves by x.
    struct Side {
        Mat6 total;                                                         ///< by x
        Axes mixed;                                                         ///< by x and q
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 3, 3> own; ///< by q
    };

    /// Of two bodies, by their columns; -1: none.
    struct Row {
        Eigen::Index child, parent;
        Vec6 ofChild, ofParent;
        double give = 0; ///< 1 / (kg m^2)
    };

    [[nodiscard]] Axes axesOf(const OdeJoint& joint) const;
    [[nodiscard]] static Vec6 turningOf(const OdeJoint& joint, const Axes& axes);
    [[nodiscard]] static Eigen::Index columnOf(std::span<const std::uint32_t> bodies, std::uint32_t body);
    [[nodiscard]] std::vector<Row> rowsOf(std::span<const std::uint32_t> bodies) const;
    [[nodiscard]] Side sideWithRotors(const OdeJoint& joint, bool isChild, const Mat6& inertia) const;
    [[nodiscard]] Mat6 throughJoint(const OdeJoint& joint, bool isChild, const Mat6& inertia) const;
    [[nodiscard]] Mat6 inertiaOf(std::uint32_t body) const;
    [[nodiscard]] Mat6 sideOf(std::uint32_t body, std::uint32_t without);

    const std::vector<OdeBody>& m_bodies;
    const std::vector<OdeJoint>& m_joints;
    std::vector<std::vector<std::uint32_t>> m_jointsOf; ///< by body
    std::vector<std::uint32_t> m_visited;               ///< bodies
    Vec3 m_origin = Vec3::Zero(); ///< all 6-vectors are about this point, in world axes: rotation, translation
};

} // namespace trundle
