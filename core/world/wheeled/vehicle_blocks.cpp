#include "world/wheeled/vehicle_blocks.h"

#include <algorithm>

namespace trundle {

static_assert(kVehicleRows == kMostSupports);

namespace {

/// Shares of the weight on supports that give way alike, as those of the general engine do: load = a + b x + c y. One that would pull
/// carries nothing.
std::vector<double> loadsAtRest(std::span<const Support> supports) {
    std::vector<double> loads(supports.size(), 0);
    std::vector<bool> carries(supports.size(), true);
    const auto at = [&](std::size_t i) { return Vec3(1, supports[i].centre.x(), supports[i].centre.y()); };
    for (bool again = true; again;) {
        again = false;
        Mat3 sums = Mat3::Zero();
        for (std::size_t i = 0; i < supports.size(); ++i)
            if (carries[i]) sums += at(i) * at(i).transpose();
        const Vec3 slope = sums.completeOrthogonalDecomposition().solve(Vec3::UnitX()); // all may be on one line
        for (std::size_t i = 0; i < supports.size(); ++i) {
            loads[i] = carries[i] ? at(i).dot(slope) : 0;
            if (loads[i] >= 0) continue;
            loads[i] = 0;
            carries[i] = false;
            again = true;
        }
    }
    return loads;
}

} // namespace

VehicleModel vehicleModel(const ActorShape& shape, const WheeledObjects& objects) {
    VehicleModel model;
    model.supportCount = static_cast<int>(shape.supports.size());
    model.wheelCount = static_cast<int>(shape.wheels.size());
    model.mass = shape.mass;
    model.planar = objects.planar;
    const Mat3 inverse = objects.planar ? Mat3(Vec3(0, 0, 1 / shape.inertia(2, 2)).asDiagonal()) : Mat3(shape.inertia.inverse());
    const double parts[6] = {inverse(0, 0), inverse(0, 1), inverse(0, 2), inverse(1, 1), inverse(1, 2), inverse(2, 2)};
    std::ranges::copy(parts, model.inverseInertia);
    model.stiffness = shape.stiffness;
    model.damping = shape.damping;
    for (std::size_t i = 0; i < shape.wheels.size(); ++i) model.wheelDamping[i] = shape.wheels[i].damping;
    const std::vector<double> loads = loadsAtRest(shape.supports);
    for (std::size_t i = 0; i < shape.supports.size(); ++i) {
        const Support& s = shape.supports[i];
        model.supports[i] = {{s.centre.x(), s.centre.y(), s.centre.z()},
                             s.radius,
                             {s.way.x(), s.way.y()},
                             s.lever,
                             objects.friction(s.surface, objects.ground->surface()),
                             static_cast<int>(s.wheel),
                             s.round,
                             loads[i] * shape.mass * objects.weight};
    }
    return model;
}

namespace {

void put(VehicleField* to, std::size_t lane, const Vec3& v) {
    for (int k = 0; k < 3; ++k) to[k][lane] = v[k];
}
Vec3 vectorIn(const VehicleField* from, std::size_t lane) { return {from[0][lane], from[1][lane], from[2][lane]}; }

void loadWheel(VehicleWheelRow& to, std::size_t lane, const WheelState& wheel) {
    to.spin[lane] = wheel.spin;
    to.angle[lane] = wheel.angle;
    to.torque[lane] = wheel.torque;
    to.inertia[lane] = wheel.inertia;
    to.rate[lane] = wheel.motor.rate;
    to.softness[lane] = wheel.motor.softness;
    to.limit[lane] = wheel.motor.limit;
    to.damping[lane] = wheel.motor.damping;
    to.dry[lane] = wheel.motor.dryFriction;
    to.viscous[lane] = wheel.motor.viscousFriction;
}

void loadVehicle(VehicleBlock& block, std::size_t lane, const WheeledObjects& objects, std::uint32_t index) {
    const WheeledUnit& unit = objects.units[index];
    put(block.position, lane, unit.position);
    block.height[lane] = unit.position.z() - objects.ground->height;
    block.rotation[0][lane] = unit.rotation.w();
    put(block.rotation + 1, lane, unit.rotation.vec());
    block.c[lane] = unit.plane.c;
    block.s[lane] = unit.plane.s;
    put(block.linear, lane, unit.linear);
    put(block.angular, lane, unit.angular);
    put(block.force, lane, unit.force);
    put(block.moment, lane, unit.moment);
    const VehicleModel& model = objects.models[unit.model];
    for (int i = 0; i < model.supportCount; ++i) {
        const SupportState& state = objects.supports[unit.supports + static_cast<std::uint32_t>(i)];
        VehicleSupportRow& row = block.supports[i];
        row.normal[lane] = state.normal;
        row.alongImpulse[lane] = state.along;
        row.acrossImpulse[lane] = state.across;
        row.cone[lane] = state.cone;
    }
    for (int i = 0; i < model.wheelCount; ++i)
        loadWheel(block.wheels[i], lane, objects.wheels[unit.wheels + static_cast<std::uint32_t>(i)]);
}

} // namespace

void loadVehicles(VehicleBlock& block, const WheeledObjects& objects, std::span<const std::uint32_t> units) {
    for (std::size_t lane = 0; lane < kVehicleLanes; ++lane)
        loadVehicle(block, lane, objects, units[std::min(lane, units.size() - 1)]);
}

void storeVehicle(const VehicleBlock& block, std::size_t lane, WheeledObjects& objects, std::uint32_t index) {
    WheeledUnit& unit = objects.units[index];
    const VehicleModel& model = objects.models[unit.model];
    unit.position = vectorIn(block.position, lane);
    unit.rotation = {block.rotation[0][lane], block.rotation[1][lane], block.rotation[2][lane], block.rotation[3][lane]};
    unit.plane = {unit.position.head<2>(), block.c[lane], block.s[lane]};
    unit.linear = vectorIn(block.linear, lane);
    unit.angular = vectorIn(block.angular, lane);
    for (int i = 0; i < model.supportCount; ++i) {
        const VehicleSupportRow& row = block.supports[i];
        objects.supports[unit.supports + static_cast<std::uint32_t>(i)] = {row.keptNormal[lane], row.keptAlong[lane], row.keptAcross[lane],
                                                                           row.keptCone[lane]};
    }
    for (int i = 0; i < model.wheelCount; ++i) {
        const VehicleWheelRow& row = block.wheels[i];
        WheelState& wheel = objects.wheels[unit.wheels + static_cast<std::uint32_t>(i)];
        wheel.spin = row.spin[lane];
        wheel.angle = row.angle[lane];
        wheel.impulse = row.impulse[lane];
        wheel.friction = row.friction[lane];
        wheel.halfCosine = row.halfCosine[lane];
        wheel.halfSine = row.halfSine[lane];
    }
}

VehiclePushes pushesAt(const VehicleBlock& block, std::size_t lane, double mass, const Vec3& arm, const Vec2& normal) {
    const double c = block.middleC[lane], s = block.middleS[lane];
    const Vec3 at(c * arm.x() + s * arm.y(), c * arm.y() - s * arm.x(), arm.z());
    const auto in = [&](int k) { return block.inverse[k][lane]; };
    const auto fill = [&](VehiclePush& push, double x, double y) {
        const Vec3 turn(-at.z() * y, at.z() * x, at.x() * y - at.y() * x);
        const double row[5] = {x, y, turn.x(), turn.y(), turn.z()};
        const double change[5] = {x / mass, y / mass, in(0) * turn.x() + in(1) * turn.y() + in(2) * turn.z(),
                                  in(1) * turn.x() + in(3) * turn.y() + in(4) * turn.z(),
                                  in(2) * turn.x() + in(4) * turn.y() + in(5) * turn.z()};
        std::ranges::copy(row, push.row);
        std::ranges::copy(change, push.change);
    };
    VehiclePushes out;
    const double x = c * normal.x() + s * normal.y(), y = c * normal.y() - s * normal.x();
    fill(out.normal, x, y);
    fill(out.tangent, -y, x);
    return out;
}

} // namespace trundle
