#include "world/world_supply.h"

#include <cmath>

namespace trundle {

bool WorldSupply::provide(std::uint32_t robot, double nominal, double voltage) {
    if (robot >= m_robots.size()) m_robots.resize(robot + 1);
    if (m_robots[robot].present) return false;
    m_robots[robot] = {true, nominal, voltage, {}};
    return true;
}

RobotSupply* WorldSupply::supply(std::uint32_t robot) { return const_cast<RobotSupply*>(find(robot)); }

void WorldSupply::draw(std::uint32_t robot, double watts, double conductance) {
    RobotSupply* from = supply(robot);
    if (!from || !std::isfinite(watts) || !std::isfinite(conductance)) return;
    (conductance > 0 ? from->load.resistive : from->load.regulated) += watts;
    if (conductance > 0) from->load.conductance += conductance;
}

void WorldSupply::setVoltage(std::uint32_t robot, double voltage) {
    if (RobotSupply* of = supply(robot); of && std::isfinite(voltage)) of->voltage = voltage;
}

void WorldSupply::clearLoads() {
    for (RobotSupply& robot : m_robots) robot.load = {};
}

} // namespace trundle
