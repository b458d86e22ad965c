#pragma once
// Updates of controllers whose kinds are independent of other robots, on all threads of the world.

#include <span>
#include <vector>

#include "run/running_controller.h"

namespace trundle {

class ApartUpdates {
public:
    /// Of those that are due, where there are several threads. What they put out is passed on by their update(), in its order.
    void run(std::span<RunningController> controllers, World& world, CallMonitor& calls, std::uint64_t tick, double time);

private:
    /// Of its robot, at or behind index i: a thread has all controllers of a robot or none.
    [[nodiscard]] std::size_t firstFrom(std::size_t i) const;

    std::vector<RunningController*> m_due; ///< robot by robot
};

} // namespace trundle
