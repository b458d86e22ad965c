#include "devices/kinematics.h"

#include <cmath>
#include <numbers>

namespace trundle {

ChassisMotion chassisFromWheels(const WheelMotion& wheels, double r, double d) {
    return {r * (wheels.right + wheels.left) / 2, r * (wheels.right - wheels.left) / d, 0};
}

WheelMotion wheelsFromChassis(const ChassisMotion& chassis, double r, double d) {
    const double difference = chassis.angular * d / 2;
    return {(chassis.linear - difference) / r, (chassis.linear + difference) / r};
}

namespace {

/// Chord divided by arc, of half the angle.
double chordShare(double half) { return std::abs(half) < 1e-8 ? 1.0 : std::sin(half) / half; }

} // namespace

PlanePose alongArc(const PlanePose& from, const ChassisMotion& travel) {
    const double half = travel.angular / 2;
    const double chord = chordShare(half);
    const double direction = from.heading + half;
    const double ahead = travel.linear * chord, aside = travel.lateral * chord, c = std::cos(direction), s = std::sin(direction);
    return {from.x + ahead * c - aside * s, from.y + ahead * s + aside * c, from.heading + travel.angular};
}

ChassisMotion motionBetween(const PlanePose& from, const PlanePose& to) {
    const double turned = std::remainder(to.heading - from.heading, 2 * std::numbers::pi), direction = from.heading + turned / 2;
    const double x = to.x - from.x, y = to.y - from.y, c = std::cos(direction), s = std::sin(direction),
                 chord = chordShare(turned / 2);
    return {(x * c + y * s) / chord, turned, (y * c - x * s) / chord};
}

} // namespace trundle
