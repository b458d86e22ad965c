#pragma once
// ODE's motor joints as rows about the axes of another joint.

#include <span>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

/// A motor joint with one row for each of the axes (world), beside a joint.
[[nodiscard]] dJointID axisMotor(const OdeJoint& joint, const std::vector<OdeBody>& bodies, std::span<const Vec3> axes,
                                 bool parentFirst);
void setRow(dJointID motor, JointType of, int axis, int parameter, double value);
[[nodiscard]] double rowOf(dJointID motor, JointType of, int axis, int parameter);

} // namespace trundle
