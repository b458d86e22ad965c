#pragma once
// The electric power of robots: what their batteries give, and what their devices draw.

#include <cstdint>
#include <vector>

#include <trundle/abi_supply.h>

namespace trundle {

/// A device of the robot decides on the voltage; in each tick it gets the sum of what all others drew.
struct RobotSupply {
    bool present = false;
    double nominal = 0, voltage = 0; ///< V; voltage: of this tick
    TrundleLoad load{};
};

class WorldSupply {
public:
    /// False: the robot has another one.
    [[nodiscard]] bool provide(std::uint32_t robot, double nominal, double voltage);
    /// nullptr: the robot has none.
    [[nodiscard]] const RobotSupply* find(std::uint32_t robot) const {
        return robot < m_robots.size() && m_robots[robot].present ? &m_robots[robot] : nullptr;
    }
    // Ignored for a robot without one, and with values that are not finite.
    void draw(std::uint32_t robot, double watts, double conductance);
    void setVoltage(std::uint32_t robot, double voltage);
    /// Before the devices of a tick sense.
    void clearLoads();

private:
    [[nodiscard]] RobotSupply* supply(std::uint32_t robot);
    std::vector<RobotSupply> m_robots; ///< by robot, up to the last that has one
};

} // namespace trundle
