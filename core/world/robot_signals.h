#pragma once
// The state signals of robots: where they are in the block, and their values after a tick.

#include <vector>

#include "signals/block.h"
#include "signals/layout.h"
#include "world/world_devices.h"
#include "world/world_objects.h"

namespace trundle {

class RobotSignals {
public:
    /// For each robot: its state signals, contiguous, then those of the devices and of the controller.
    [[nodiscard]] SignalLayout layOut(const WorldObjects& objects, WorldDevices& devices);
    void publish(const WorldObjects& objects, const Engine& engine, std::uint64_t ticks, SignalBlock& block) const;

private:
    std::vector<std::uint32_t> m_images; ///< by robot: first slot of its signals
};

} // namespace trundle
