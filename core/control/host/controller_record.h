#pragma once
#include <cstdint>
#include <span>
#include <string>

#include "control/host/wire.h"
#include "model/experiment_spec.h"
#include "signals/layout.h"

namespace trundle {

/// What a host process needs of a robot to run its controller.
struct ControllerRecord {
    RobotSpec robot; ///< name, controller, devices with kind and UpdatePeriod, names of published signals
    SettingsSpec settings;
    SignalLayout layout;      ///< of this robot alone
    std::uint64_t offset = 0; ///< of the first slot in the host's images
};

/// The entries of a robot's image, by offset.
[[nodiscard]] std::span<const SignalEntry> entriesOf(const SignalLayout& layout, const std::string& robot);
void write(WireWriter& out, const RobotSpec& robot, const SettingsSpec& settings, std::span<const SignalEntry> entries,
           std::uint64_t offset);
[[nodiscard]] ControllerRecord readControllerRecord(WireReader& in);

} // namespace trundle
