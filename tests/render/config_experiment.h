#pragma once
#include <memory>
#include <string>

#include "model/experiment_spec.h"

namespace trundle {

struct LoadedProject;

/// What the experiment file of that name means, as far as pictures go: logs, modules and meshes are left out. nullptr where the
/// file cannot be read.
[[nodiscard]] std::shared_ptr<const ExperimentSpec> readExperiment(const std::string& path);
/// The same with what is wrong with it.
[[nodiscard]] std::shared_ptr<const LoadedProject> readProject(const std::string& path);

} // namespace trundle
