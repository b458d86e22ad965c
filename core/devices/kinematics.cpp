#include "devices/kinematics.h"

#include <cmath>

namespace trundle {

ChassisMotion chassisFromWheels(const WheelMotion& wheels, double r, double d) {
    return {r * (wheels.right + wheels.left) / 2, r * (wheels.right - wheels.left) / d, 0};
}

WheelMotion wheelsFromChassis(const ChassisMotion& chassis, double r, double d) {
    const double difference = chassis.angular * d / 2;
    return {(chassis.linear - difference) / r, (chassis.linear + difference) / r};
}

PlanePose alongArc(const PlanePose& from, const ChassisMotion& travel) {
    const double half = travel.angular / 2;
    const double chord = std::abs(half) < 1e-8 ? 1.0 : std::sin(half) / half; // chord divided by arc
    const double direction = from.heading + half;
    const double ahead = travel.linear * chord, aside = travel.lateral * chord, c = std::cos(direction), s = std::sin(direction);
    return {from.x + ahead * c - aside * s, from.y + ahead * s + aside * c, from.heading + travel.angular};
}

} // namespace trundle
