#pragma once
// Controllers of robots: lists them, and plans edits that assign and remove them.

#include <string>
#include <vector>

#include "project/edits/plans.h"

namespace trundle {

/// A Robot, Grid or Scatter and one of its controllers.
struct ControlledRobot {
    std::string path;             ///< "robot0", "swarm"
    std::string kind, controller; ///< "LinearMotion", "brain"; empty: none
    std::size_t members = 1, controllers = 0; ///< that it has in all
    /// "robot0", or "robot0.brain" if it has several: how the functions below name it.
    [[nodiscard]] std::string target() const { return controllers > 1 ? path + "." + controller : path; }
    /// Whether it, or its robot as a whole, is among those.
    [[nodiscard]] bool isAmong(const std::vector<std::string>& targets) const;
};
/// One for each controller, and one for each robot without.
[[nodiscard]] std::vector<ControlledRobot> controlledRobots(const LoadedProject& loaded);
/// The robots that contain the selected paths: "robot0.chassis" → "robot0", "swarm_3" → "swarm"; without duplicates. Of a robot with
/// several controllers one that is selected itself: "robot0.brain".
[[nodiscard]] std::vector<std::string> robotsAmong(const LoadedProject& loaded, const std::vector<std::string>& paths);

/// A controller that can be assigned.
struct ControllerChoice {
    Kind kind;
    std::string module; ///< module to load first, as in #loadModule; empty: already loaded
};
/// The loaded controllers, then those of the modules in `shippedModules`, the program's folder. Alphabetical.
[[nodiscard]] std::vector<ControllerChoice> controllerChoices(const LoadedProject& loaded, const std::vector<Kind>& moduleKinds,
                                                              const std::string& shippedModules);

/// Assigns a controller to robots. It replaces an existing one, the first if only the robot is named, and keeps its name and the
/// values of properties that both kinds have. Its module must be loaded.
[[nodiscard]] Result<EditPlan> planAssign(const LoadedProject& loaded, const std::vector<std::string>& robots,
                                          const Kind& controller);
[[nodiscard]] Result<EditPlan> planUnassign(const LoadedProject& loaded, const std::vector<std::string>& robots);

} // namespace trundle
