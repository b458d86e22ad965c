#pragma once
#include "base/diagnostic.h"
#include "model/experiment_spec.h"
#include "run/log.h"
#include "schema/registry.h"

namespace trundle {

/// Adds PoseLog, SignalLog, ContactLog, EnergyLog, RadioLog and LinkMatrix.
[[nodiscard]] Status addLogKinds(Registry& registry);

/// The log that a spec asks for; nullptr with a diagnostic where it cannot be had.
[[nodiscard]] std::unique_ptr<Log> makeLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);

/// "path.csv" or what `File` says.
[[nodiscard]] std::string logFileName(const ComponentSpec& spec);

/// What can be said of an experiment's logs without a world: robots that do not exist, files that may not be, files named twice.
/// Says nothing of signals.
void checkLogs(const ExperimentSpec& experiment, Diagnostics& diagnostics);

/// Says which Signals of the logs do not exist in the layout of the experiment's world.
void checkLogSignals(const ExperimentSpec& experiment, const SignalLayout& layout, Diagnostics& diagnostics);

} // namespace trundle
