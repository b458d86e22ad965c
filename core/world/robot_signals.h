#pragma once
// The state signals of robots: where they are in the block, and their values after a tick.

#include <vector>

#include "signals/block.h"
#include "signals/layout.h"
#include "world/world_devices.h"
#include "world/world_objects.h"
#include "world/world_regions.h"

namespace trundle {

class RobotSignals {
public:
    /// For each robot: its state signals, contiguous, then those of the devices and of the controller. After the robots what is between
    /// them: joints, springs, regions.
    [[nodiscard]] SignalLayout layOut(const ExperimentSpec& experiment, const WorldObjects& objects, WorldDevices& devices);
    void publish(const WorldObjects& objects, Engine& engine, const WorldRegions& regions, std::uint64_t ticks,
                 SignalBlock& block) const;

private:
    std::vector<std::uint32_t> m_images; ///< by robot: first slot of its signals
    std::uint32_t m_between = 0;         ///< first slot of what is between robots
};

} // namespace trundle
