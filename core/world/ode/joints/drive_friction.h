#pragma once
// The friction of what drives a joint: two rows about its axis. Dry friction is a stiff row to rest with a limit, viscous friction a damper.

#include <vector>

#include "world/ode/objects/ode_records.h"
#include "world/spring_row.h"

namespace trundle {

/// Of a joint about its axis without its motor, N m s/rad.
[[nodiscard]] double dampingOf(const OdeJoint& joint);
/// Part `damping` of all of the joint's damping, as one damper with the rest of it.
[[nodiscard]] SpringRow damperRow(const OdeJoint& joint, double damping, double all, double h);

/// Makes the rows of a joint that has none yet.
void addFrictionRows(OdeJoint& joint, const std::vector<OdeBody>& bodies, dJointFeedback* feedback);
/// For a step, by the joint's motor; `viscous`: its damper.
void setFrictionRows(const OdeJoint& joint, const SpringRow& viscous);
/// In the last step, N m or N.
[[nodiscard]] double frictionEffortOf(const OdeJoint& joint);

} // namespace trundle
