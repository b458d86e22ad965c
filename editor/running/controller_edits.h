#pragma once
// Modules and controllers of an experiment: what there is, and edits of its text that change it.

#include <string>
#include <vector>

#include <QString>

#include "parts/locations.h"
#include "parts/open_options.h"
#include "project/plans.h"
#include "project/project.h"

namespace trundle {

/// One #loadModule of the project.
struct ModuleInfo {
    std::string written; ///< as in the text: "controllers/linear_motion"
    std::string library; ///< absolute; empty where it is not found
    std::vector<std::string> kinds;
    QString version;     ///< of the SDK it was built with
    QString trouble;     ///< why it cannot be used; empty where it can
    bool trusted = true; ///< false: found, but its folder is not trusted
    SourceRange range;   ///< of the path in the text
    std::string usedBy;  ///< a robot that has a kind of it; empty: none
};
[[nodiscard]] std::vector<ModuleInfo> modulesOf(const Loaded& loaded, const OpenOptions& options, const Locations& places);

/// A Robot, Grid or Scatter and its controller.
struct ControlledRobot {
    std::string path;             ///< "robot0", "swarm"
    std::string kind, controller; ///< "LinearMotion", "brain"; empty: none
    std::size_t members = 1;
};
[[nodiscard]] std::vector<ControlledRobot> controlledRobots(const Loaded& loaded);
/// Those that selected paths mean or stand in: "robot0.chassis" → "robot0", "swarm_3" → "swarm"; each once.
[[nodiscard]] std::vector<std::string> robotsAmong(const Loaded& loaded, const std::vector<std::string>& paths);

/// A controller that can be assigned.
struct ControllerChoice {
    Kind kind;
    std::string module; ///< to be loaded first, as #loadModule names it; empty: it is loaded
};
/// The loaded ones, then those of the modules that came with the program. Alphabetical.
[[nodiscard]] std::vector<ControllerChoice> controllerChoices(const Loaded& loaded, const std::vector<Kind>& moduleKinds,
                                                              const Locations& places);

/// Gives robots a controller; one that they have makes room, and leaves its name and what both kinds have alike. Its module is
/// loaded already.
[[nodiscard]] Result<EditPlan> planAssign(const Loaded& loaded, const std::vector<std::string>& robots, const Kind& controller);
[[nodiscard]] Result<EditPlan> planUnassign(const Loaded& loaded, const std::vector<std::string>& robots);
[[nodiscard]] Result<EditPlan> planLoadModule(const Loaded& loaded, const std::string& written);
/// Fails, naming who, where something has a kind of it.
[[nodiscard]] Result<EditPlan> planUnloadModule(const Loaded& loaded, const ModuleInfo& module);

/// How a #loadModule of the opened file names a library: from the program's module folder, its own folder or one of `moduleFolders`
/// (those of the command line) on; `../` leads to another folder of the project. Absolute where it lies outside all of these.
[[nodiscard]] std::string writtenFor(const std::string& library, const Loaded& loaded, const Locations& places,
                                     const std::vector<std::string>& moduleFolders = {});

} // namespace trundle
