#pragma once
// Devices seen through the interfaces of Player (Gerkey, Vaughan, Howard: The Player/Stage project, 2003): position2d, position1d,
// ranger, bumper, camera, wsn. A client that speaks of these needs no names of Trundle's kinds and signals.

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/experiment_spec.h"
#include "signals/block.h"

namespace trundle {

/// A value that an interface reads: "pos", from the signal "odometry" of the device.
struct ViewData {
    std::string_view name, signal;
};
/// One signal that a command of an interface writes: element `element` of its value, or a constant if that is negative.
struct ViewWrite {
    std::string_view signal;
    int element = 0;
    double constant = 0;
};
struct ViewCommand {
    std::string_view name;
    std::size_t size = 1; ///< numbers of its value
    std::span<const ViewWrite> writes;
};
struct DeviceView {
    std::string_view kind, interface;
    std::span<const ViewData> data;
    std::span<const ViewCommand> commands;
};

/// The view of a kind of device; nullptr: it has none of its own, its interface is "opaque".
[[nodiscard]] const DeviceView* viewOf(std::string_view kind);
[[nodiscard]] std::string interfaceOf(std::string_view kind);

/// The device "rover/base" of an experiment; nullptr if it has no such device.
[[nodiscard]] const ComponentSpec* deviceAt(const ExperimentSpec& experiment, std::string_view path);

} // namespace trundle
