#pragma once
// Whatever comes from outside a run - a push, a pose, a value - enters as a command stamped with its tick and is kept.

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
/// Writes one command signal, "robot0/base/linearVelocity".
struct SignalCommand {
    std::string path;
    double value = 0;
};
/// While held a robot's controller has no turn: somebody else commands.
struct HoldCommand {
    std::string robot;
    bool held = true;
};
/// Gives a surface other values, by its name. Contacts of the coming tick have them.
struct SurfaceCommand {
    SurfaceSpec surface;
};
/// Sets a property that may change during a run, of a device or controller "robot0/leftMotor".
struct PropertyCommand {
    std::string object, property;
    PropertyValue value;
};

/// Applied before tick `tick + 1` thinks: `tick` is the number of completed ticks.
struct Command {
    std::uint64_t tick = 0;
    std::variant<PushCommand, PlaceCommand, SignalCommand, HoldCommand, SurfaceCommand, PropertyCommand> what;
};

} // namespace trundle
