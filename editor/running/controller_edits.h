#pragma once
// Modules and controllers of an experiment: lists them, and plans edits that change them.

#include <string>
#include <vector>

#include <QString>

#include "app/locations.h"
#include "app/open_options.h"
#include "project/edits/plans.h"
#include "project/loading/project.h"

namespace trundle {

/// One #loadModule of the project.
struct ModuleInfo {
    std::string written; ///< as in the text: "controllers/linear_motion"
    std::string library; ///< absolute path; empty if not found
    std::vector<std::string> kinds;
    QString version;     ///< version of the SDK that it was built with
    QString trouble;     ///< why it cannot be used; empty if it can
    bool trusted = true; ///< false: found, but in a folder that is not trusted
    SourceRange range;   ///< of the path in the text
    std::string usedBy;  ///< a robot that uses one of its kinds; empty: none
};
[[nodiscard]] std::vector<ModuleInfo> modulesOf(const LoadedProject& loaded, const OpenOptions& options, const Locations& places);

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
/// The loaded controllers, then those of the modules installed with Trundle. Alphabetical.
[[nodiscard]] std::vector<ControllerChoice> controllerChoices(const LoadedProject& loaded, const std::vector<Kind>& moduleKinds,
                                                              const Locations& places);

/// Assigns a controller to robots. It replaces an existing one and keeps its name and the values of properties that both kinds
/// have. Its module must be loaded.
[[nodiscard]] Result<EditPlan> planAssign(const LoadedProject& loaded, const std::vector<std::string>& robots,
                                          const Kind& controller);
[[nodiscard]] Result<EditPlan> planUnassign(const LoadedProject& loaded, const std::vector<std::string>& robots);
[[nodiscard]] Result<EditPlan> planLoadModule(const LoadedProject& loaded, const std::string& written);
/// Fails if a block uses one of the module's kinds, and names the block.
[[nodiscard]] Result<EditPlan> planUnloadModule(const LoadedProject& loaded, const ModuleInfo& module);

/// The path that a #loadModule of the opened file uses for a library: relative to the program's module folder, the file's own
/// folder or one of `moduleFolders` (those of the command line), or by `../` to another folder of the project. Absolute if it is
/// outside of all these.
[[nodiscard]] std::string writtenFor(const std::string& library, const LoadedProject& loaded, const Locations& places,
                                     const std::vector<std::string>& moduleFolders = {});

} // namespace trundle
