#pragma once
// Controllers of robots: lists them, and plans edits that assign and remove them.

#include <string>
#include <vector>

#include "project/edits/plans.h"

namespace trundle {

/// A Robot, Grid or Scatter and its controller.
struct ControlledRobot {
    std::string path;             ///< "robot0", "swarm"
    std::string kind, controller; ///< "LinearMotion", "brain"; empty: none
    std::size_t members = 1;
};
[[nodiscard]] std::vector<ControlledRobot> controlledRobots(const LoadedProject& loaded);
/// The robots that contain the selected paths: "robot0.chassis" → "robot0", "swarm_3" → "swarm"; without duplicates.
[[nodiscard]] std::vector<std::string> robotsAmong(const LoadedProject& loaded, const std::vector<std::string>& paths);

/// A controller that can be assigned.
struct ControllerChoice {
    Kind kind;
    std::string module; ///< module to load first, as in #loadModule; empty: already loaded
};
/// The loaded controllers, then those of the modules in `shippedModules`, the program's folder. Alphabetical.
[[nodiscard]] std::vector<ControllerChoice> controllerChoices(const LoadedProject& loaded, const std::vector<Kind>& moduleKinds,
                                                              const std::string& shippedModules);

/// Assigns a controller to robots. It replaces an existing one and keeps its name and the values of properties that both kinds
/// have. Its module must be loaded.
[[nodiscard]] Result<EditPlan> planAssign(const LoadedProject& loaded, const std::vector<std::string>& robots,
                                          const Kind& controller);
[[nodiscard]] Result<EditPlan> planUnassign(const LoadedProject& loaded, const std::vector<std::string>& robots);

} // namespace trundle
