#pragma once
// Whether the states after a step are plausible.

#include <optional>

#include "world/ode/cluster_solver.h"
#include "world/ode/joint_rows.h"

namespace trundle {

/// The first body that is no number, too fast or too far away, else the first joint that is torn open.
[[nodiscard]] std::optional<EngineFault> findFault(const OdeObjects& objects, const JointRows& rows, const ClusterSolver& solver);

/// The fault of a step that ODE could not finish: names the body with an invalid state, otherwise the lightest one, which is the
/// usual cause.
[[nodiscard]] EngineFault interruptedFault(const OdeObjects& objects);

} // namespace trundle
