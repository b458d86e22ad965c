#pragma once
#include <cstdint>
#include <string>

#include "control/host/wire.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// What a host process needs of a robot to run its controller.
struct ControllerRecord {
    RobotSpec robot; ///< name, devices with kind and UpdatePeriod; names of all controllers, and all of one of them
    std::size_t controller = 0; ///< its index; its published signals have names, directions and counts alone
    SettingsSpec settings;
    SignalLayout layout;      ///< of this robot alone
    std::uint64_t offset = 0; ///< of the first slot in the host's images
};

/// `entries`: those of the robot.
void write(WireWriter& out, const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
           const SignalLayout::Range& entries, std::uint64_t offset);
[[nodiscard]] ControllerRecord readControllerRecord(WireReader& in);

} // namespace trundle
