#pragma once
// Commands from outside a run, such as pushes, poses and values. Each is stamped with its tick and recorded.

#include <cstdint>
#include <optional>
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
/// Writes one number of a command signal, such as "robot0/base/linearVelocity".
struct SignalCommand {
    std::string path;
    double value = 0;
    std::uint32_t element = 0; ///< which one, of a signal with several
};
/// Who holds a robot: the user of the window, or programs that control the run.
enum class Holder { Window, Guest };
/// While anyone holds a robot, its controllers are not called: commands come from elsewhere.
struct HoldCommand {
    std::string robot;
    bool held = true;
    Holder holder = Holder::Window;
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
/// Starts controllers of a robot again, from their setup; if their process has ended, all that shared it.
struct RestartCommand {
    std::string robot, controller; ///< the name of one; empty: all
};
/// Loads the module with this path again, as a new file, and starts its controllers from their setup. Poses and time stay. A module
/// that cannot be used is refused, and the old code continues. Only for controllers in host processes.
struct ReloadCommand {
    std::string module; ///< empty: all modules
};

/// Controllers of a robot are not called any more, and their commands become 0, until a RestartCommand or new code.
struct StopCommand {
    std::string robot, controller; ///< the name of one; empty: all
};

/// Another controller takes the place of one of a robot, or comes beside those that it has, and begins with its setup; poses and time stay. What
/// it publishes has signals only where the one that the run began with has published the same; the rest has none until the next run. One
/// whose ports claim a command of another controller is stopped (E319). Until the next run, one that came is called after the others.
struct SwapCommand {
    std::string robot, controller;    ///< the name of the old one; empty: one more
    std::optional<ControllerSpec> to; ///< none: the old one leaves
    std::string library;              ///< path of the module with its kind
};

/// Applied before the controllers are called in tick `tick + 1`: `tick` is the number of completed ticks.
struct Command {
    std::uint64_t tick = 0;
    std::variant<PushCommand, PlaceCommand, SignalCommand, HoldCommand, SurfaceCommand, PropertyCommand, RestartCommand,
                 ReloadCommand, StopCommand, SwapCommand>
        what;
};

} // namespace trundle
