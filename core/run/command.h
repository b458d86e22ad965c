#pragma once
// Whatever comes from outside a run - a push, a pose, a value - enters as a command stamped with its tick and is kept.

#include <string>
#include <variant>
#include <vector>

#include <trundle/geometry.h>

namespace trundle {

struct PushCommand { std::string body; Vec3 force = Vec3::Zero(), point = Vec3::Zero(); };
struct PlaceCommand { std::string robot; Pose pose; };
/// Writes one command signal, "robot0/base/linearVelocity".
struct SignalCommand { std::string path; double value = 0; };

/// Applied before tick `tick + 1` thinks: `tick` is the number of completed ticks.
struct Command {
    std::uint64_t tick = 0;
    std::variant<PushCommand, PlaceCommand, SignalCommand> what;
};

} // namespace trundle
