#include <algorithm>
#include <numbers>

#include "project/wizard/robot_design.h"

namespace trundle {
namespace {

constexpr double kRpm = std::numbers::pi / 30; // rad/s
constexpr double kKgCm = 0.0980665;            // N m
constexpr double kHalf = 0.5;                  // of the stall torque

// The motors of maxon are given without their gear.
constexpr double kRe40Rpm = 7580, kRe40Torque = 2.42, kRe40Current = 80.2, kGp42Efficiency = 0.81;

} // namespace

double GearMotor::usableTorque() const { return std::min(kHalf * stallTorque, gearTorque); }

// Pololu, "Micro Metal Gearmotors", HPCB 12 V, 75:1, and "37D Metal Gearmotors", revision 1.2, 12 V; stall values are extrapolated there,
// and the gears take 2 and 25 kg cm for an instant. maxon motor, catalogue: RE 40, 150 W, 24 V (148867), and planetary gearhead GP 42 C
// with two stages, at most 11.3 N m for a short time.
const std::vector<GearMotor>& gearMotors() {
    static const std::vector<GearMotor> motors{
        {"Pololu 75:1 Micro Metal HPCB 12 V", 12, 450 * kRpm, 1.0 * kKgCm, 0.75, 75.81, 2 * kKgCm},
        {"Pololu 70:1 37D 12 V", 12, 150 * kRpm, 27 * kKgCm, 5.5, 70, 25 * kKgCm},
        {"Pololu 50:1 37D 12 V", 12, 200 * kRpm, 21 * kKgCm, 5.5, 50, 25 * kKgCm},
        {"Pololu 30:1 37D 12 V", 12, 330 * kRpm, 14 * kKgCm, 5.5, 30, 25 * kKgCm},
        {"Pololu 19:1 37D 12 V", 12, 530 * kRpm, 8.5 * kKgCm, 5.5, 18.75, 25 * kKgCm},
        {"Pololu 10:1 37D 12 V", 12, 1000 * kRpm, 4.9 * kKgCm, 5.5, 10, 25 * kKgCm},
        {"maxon RE 40 with GP 42 C 26:1", 24, kRe40Rpm * kRpm / 26, kRe40Torque * 26 * kGp42Efficiency, kRe40Current, 26, 11.3},
        {"maxon RE 40 with GP 42 C 12:1", 24, kRe40Rpm * kRpm / 12, kRe40Torque * 12 * kGp42Efficiency, kRe40Current, 12, 11.3},
    };
    return motors;
}

} // namespace trundle
