#include "devices/chassis_drive.h"

#include <algorithm>
#include <cmath>

namespace trundle {
namespace {

/// rad, the mean of the wheels of one side.
template <class Wheels> double turnedSince(const Services& world, Wheels side) {
    double sum = 0;
    for (auto& wheel : side) sum += wheel.turnedSince(world);
    return sum / static_cast<double>(side.size());
}

template <class Wheels> double slipOf(const Services& world, Wheels side, double radius) {
    double sum = 0;
    for (auto& wheel : side) sum += wheel.slip(world, radius);
    return sum / static_cast<double>(side.size());
}

template <class Wheels> std::optional<Vec3> middleOf(Wheels side) {
    Vec3 sum = Vec3::Zero();
    for (const auto& wheel : side) {
        if (!wheel.isPlaced) return std::nullopt;
        sum += wheel.anchor;
    }
    return Vec3(sum / static_cast<double>(side.size()));
}

} // namespace

void SidedDrive::mountSides(Mount& mount, const std::vector<std::string>& left, const std::vector<std::string>& right) {
    std::vector<std::string> all = left;
    all.insert(all.end(), right.begin(), right.end());
    m_leftCount = left.size();
    mountWheels(mount, all);
}

void SidedDrive::driveSides(Actuation& world, const ChassisMotion& velocity) {
    const WheelMotion rates = wheelsFromChassis(velocity, radius(), separation());
    warnOfSpeeds(world, velocity.angular, std::max(std::abs(rates.left), std::abs(rates.right)));
    for (Wheel& wheel : left()) drive(world, wheel, rates.left);
    for (Wheel& wheel : right()) drive(world, wheel, rates.right);
}

const PlanePose& SidedDrive::odometer(const Services& world) {
    const WheelMotion turned{turnedSince(world, left()), turnedSince(world, right())};
    m_odometryPose = alongArc(m_odometryPose, chassisFromWheels(turned, radius(), separation()));
    return m_odometryPose;
}

std::optional<PlanePose> SidedDrive::truePose() {
    const std::optional<Vec3> a = middleOf(left()), b = middleOf(right());
    if (!a || !b) return std::nullopt;
    return PlanePose{(a->x() + b->x()) / 2, (a->y() + b->y()) / 2, std::atan2(b->x() - a->x(), a->y() - b->y())};
}

WheelMotion SidedDrive::wheelSlip(const Services& world) {
    return {slipOf(world, left(), radius()), slipOf(world, right(), radius())};
}

void ChassisDrive::act(Actuation& world) {
    const ChassisMotion velocity{linearVelocity.read(world), angularVelocity.read(world)};
    const ChassisMotion amount{linearAmount.read(world), angularAmount.read(world)};
    driveSides(world, follow(world, velocity, amount, sequence.read(world)));
}

void ChassisDrive::sense(Sensing& world) {
    publishState(*this, odometer(world));
    const WheelMotion slips = wheelSlip(world);
    publishPose(*this, truePose());
    slip.set(0, slips.left);
    slip.set(1, slips.right);
}

} // namespace trundle
