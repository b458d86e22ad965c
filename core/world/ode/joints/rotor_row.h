#pragma once
// Rotors of geared motors. A rotor turns about the joint's axis at s = (1 - G) w_parent + G w_child, so that its energy J s^2 / 2 adds
// J u u^T with u = (1 - G, G) to the masses of the two bodies. Method: a soft row for s, lambda = -J (s - s before) / h, is this
// term exactly, with the reaction that each body gets. Where the axis turns, the parent also gets the torque of a gyroscope.

#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

class RotorRows {
public:
    /// The arrays belong to the engine and outlive this.
    RotorRows(const std::vector<OdeBody>& bodies, std::vector<OdeJoint>& joints) : m_bodies(bodies), m_joints(joints) {}

    /// As Engine::addRotor; on the parent of a joint between bodies.
    [[nodiscard]] Status add(std::uint32_t joint, double inertia, double ratio);
    /// Prepares a step: gives the parents the torque of their rotors, as these turn with them.
    void update(double h);

private:
    void turn(OdeJoint& joint, double h) const;

    const std::vector<OdeBody>& m_bodies;
    std::vector<OdeJoint>& m_joints;
    std::vector<std::uint32_t> m_withRotors; ///< joints
};

} // namespace trundle
