#pragma once
#include <memory>
#include <string>

#include "model/experiment_spec.h"

namespace trundle {

struct LoadedProject;

/// Resolves an experiment file for rendering: logs, modules and meshes are left out. nullptr if the
/// file cannot be read.
[[nodiscard]] std::shared_ptr<const ExperimentSpec> readExperiment(const std::string& path);
/// The same with its diagnostics.
[[nodiscard]] std::shared_ptr<const LoadedProject> readProject(const std::string& path);

} // namespace trundle
