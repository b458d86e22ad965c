#pragma once
// Commands from outside a run, such as pushes, poses and values. Each is stamped with its tick and recorded.

#include <string>
#include <variant>
#include <vector>

#include <trundle/geometry.h>

#include "model/experiment_spec.h"

namespace trundle {

struct PushCommand {
    std::string body;
    Vec3 force = Vec3::Zero(), point = Vec3::Zero();
};
struct PlaceCommand {
    std::string robot;
    Pose pose;
};
/// Writes one command signal, such as "robot0/base/linearVelocity".
struct SignalCommand {
    std::string path;
    double value = 0;
};
/// While a robot is held, its controller is not called: commands come from elsewhere.
struct HoldCommand {
    std::string robot;
    bool held = true;
};
/// Changes the values of a surface, found by name; applies to contacts from the coming tick on.
struct SurfaceCommand {
    SurfaceSpec surface;
};
/// Sets a property that can be changed during a run, of a device or controller such as "robot0/leftMotor".
struct PropertyCommand {
    std::string object, property;
    PropertyValue value;
};
/// Starts the controller of a robot again, from its setup; if its process has ended, those of all robots that shared it.
struct RestartCommand {
    std::string robot;
};
/// Loads the module with this path again, as a new file, and starts its controllers from their setup. Poses and time stay. A module
/// that cannot be used is refused, and the old code continues. Only for controllers in host processes.
struct ReloadCommand {
    std::string module; ///< empty: all modules
};

/// The controller of a robot is not called any more, and the robot's commands become 0, until a RestartCommand or new code.
struct StopCommand {
    std::string robot;
};

/// Applied before the controllers are called in tick `tick + 1`: `tick` is the number of completed ticks.
struct Command {
    std::uint64_t tick = 0;
    std::variant<PushCommand, PlaceCommand, SignalCommand, HoldCommand, SurfaceCommand, PropertyCommand, RestartCommand,
                 ReloadCommand, StopCommand>
        what;
};

} // namespace trundle
