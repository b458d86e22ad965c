#include "devices/motor_driver.h"

#include <cmath>

namespace trundle {

double MotorDriver::voltageOf(double command, double full) const {
    if (std::abs(command) < deadBand) return 0;
    return pwmSteps > 0 ? std::round(command / full * pwmSteps) / pwmSteps * full : command;
}

} // namespace trundle
