#pragma once
// ODE's motor joints as rows about the axes of another joint.

#include <span>
#include <vector>

#include "world/ode/objects/ode_records.h"

namespace trundle {

/// Where the axis that `position` is about or along is in the world. That of a universal joint is fixed to its parent.
[[nodiscard]] Vec3 axisNow(const OdeJoint& joint, const std::vector<OdeBody>& bodies);
/// A motor joint with one row for each of the axes (world), beside a joint. The first `ofParent` of them are fixed to the parent.
[[nodiscard]] dJointID axisMotor(const OdeJoint& joint, const std::vector<OdeBody>& bodies, std::span<const Vec3> axes,
                                 int ofParent);
/// Writes the joint's axis to those axes of such a row that are fixed to the world, where it is the parent.
void setWorldAxes(dJointID motor, const OdeJoint& joint);
void setRow(dJointID motor, JointType of, int axis, int parameter, double value);
/// Multiplies the gains of a joint's stops.
void scaleStops(const OdeJoint& joint, double factor);
[[nodiscard]] double rowOf(dJointID motor, JointType of, int axis, int parameter);

} // namespace trundle
