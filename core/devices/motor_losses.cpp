#include "devices/motor_losses.h"

#include <cmath>

namespace trundle {

LossLine lossLine(const MotorLosses& losses, double torque, double rate) {
    const auto factorOf = [&](double driving) {
        return driving >= 0 || losses.backEfficiency == 0 ? losses.efficiency : 1 / losses.backEfficiency;
    };
    const auto passed = [&](double driving) { return factorOf(driving) * driving; };
    const double side = rate > 0 || (rate == 0 && torque >= 0) ? 1 : -1;
    LossLine line;
    line.factor = factorOf(side * torque - losses.dry - losses.viscous * std::abs(rate));
    line.viscous = line.factor * losses.viscous;
    const double forwards = passed(torque - losses.dry), backwards = -passed(-torque - losses.dry);
    line.dry = (backwards - forwards) / 2;
    line.offset = side * (line.dry - line.factor * losses.dry);
    return line;
}

} // namespace trundle
