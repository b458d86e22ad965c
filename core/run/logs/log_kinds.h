#pragma once
#include "base/diagnostic.h"
#include "model/experiment_spec.h"
#include "run/logs/log.h"
#include "schema/registry.h"

namespace trundle {

/// Adds PoseLog, SignalLog, ContactLog, EnergyLog, RadioLog and LinkMatrix.
[[nodiscard]] Status addLogKinds(Registry& registry);

/// Creates the log for a spec; nullptr, with a diagnostic, on failure.
[[nodiscard]] std::unique_ptr<RunLog> makeLog(const ComponentSpec& spec, const World& world, Diagnostics& diagnostics);

/// Whether it logs what no robot measures and only a simulation has: energies, contacts, the medium of radios.
[[nodiscard]] bool needsSimulation(const ComponentSpec& spec);

/// The value of `File`, or a name such as "path.csv" for a log `path`.
[[nodiscard]] std::string logFileName(const ComponentSpec& spec);

/// Checks an experiment's logs without a world: unknown robots, invalid file names, duplicate file names. Does not check signals.
void checkLogs(const ExperimentSpec& experiment, Diagnostics& diagnostics);

/// checkLogs() and, if the engine can build the world and all kinds are known, checkLogSignals(): an unknown device may have any
/// signal.
void checkLogs(const ExperimentSpec& experiment, const Registry& registry, bool allKindsKnown, Diagnostics& diagnostics);

/// Reports Signals of the logs that do not exist in the layout of the experiment's world.
void checkLogSignals(const ExperimentSpec& experiment, const SignalLayout& layout, Diagnostics& diagnostics);

} // namespace trundle
