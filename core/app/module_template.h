#pragma once
// New modules from the templates that come with the program.

#include <string>
#include <vector>

#include "app/locations.h"
#include "base/result.h"
#include "model/experiment_spec.h"

namespace trundle {

enum class ModuleTemplate { Controller, PythonController, Component, PythonComponent };
[[nodiscard]] constexpr bool isPython(ModuleTemplate what) {
    return what == ModuleTemplate::PythonController || what == ModuleTemplate::PythonComponent;
}

/// A module whose files are written, and how it is built and used.
struct NewModule {
    std::string folder;             ///< as given, with the module's own folder
    std::vector<std::string> files; ///< in that folder
    std::string source;             ///< of the files, the one to edit
    std::string library;            ///< path of what a #loadModule loads, once it is built
    std::string configure, build;   ///< command lines for a shell; empty in Python
    std::string load;               ///< the line of an experiment beside the folder
};

/// What a new controller is for.
struct CommandedRobot {
    std::string config = "SimpleRobot";
    std::string driveKind = "DifferentialDrive",
                drive = "base"; ///< its drive; empty: it has none, the controller does nothing yet
};
/// The first drive of a robot.
[[nodiscard]] CommandedRobot commandedRobot(const RobotConfigSpec& config);

/// Why a kind cannot have this name; empty if it can.
[[nodiscard]] std::string kindNameFault(const std::string& kind);
/// The same for a kind of a module, whose code and blocks begin with it: also if it is a word of their languages.
[[nodiscard]] std::string kindNameFault(ModuleTemplate what, const std::string& kind);
/// Why `what`, "a robot", cannot have this name for its config; empty if it can. `like`: a name that it can have, `imported`: that
/// of a config which the experiment written with it imports.
[[nodiscard]] std::string configNameFault(const std::string& what, const std::string& name, const std::string& like,
                                          const std::string& imported);
/// The name of a module with this kind: "wall_follow" for "WallFollow", "led_ring" for "LEDRing".
[[nodiscard]] std::string moduleNameFor(const std::string& kind);

/// Writes the template for a kind of that name into a new folder below `parent`: WallFollow becomes wall_follow/wall_follow.cpp.
/// Fails, and writes nothing, if the name cannot be a kind's, if that folder exists, or if it cannot be written.
/// `robot`: what a controller commands.
[[nodiscard]] Result<NewModule> makeModule(ModuleTemplate what, const std::string& kind, const std::string& parent,
                                           const Locations& locations, const CommandedRobot& robot = {});

} // namespace trundle
