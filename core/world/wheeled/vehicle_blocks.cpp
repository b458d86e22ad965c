#include "world/wheeled/vehicle_blocks.h"

#include <algorithm>

#include "world/wheeled/loads_at_rest.h"

namespace trundle {

static_assert(kVehicleRows == kMostSupports);

namespace {

constexpr double kUsualGravity = 9.81; // m/s^2, for which shapes have their stiffness

/// As if it were at rest; `middle` as loadsAtRest() says, in the vehicle's axes.
std::vector<double> loadsOf(const ActorShape& shape, const WheeledObjects& objects, const Vec2& middle) {
    std::vector<Vec2> points;
    for (const Support& s : shape.supports) points.emplace_back(s.centre.head<2>());
    std::vector<double> loads = loadsAtRest(points, middle);
    for (double& load : loads) load *= shape.mass * objects.weight;
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
    const double heavier = std::max(1., objects.weight / kUsualGravity); // it sags no more, and nothing sinks in
    model.stiffness = heavier * shape.stiffness;
    model.damping = heavier * shape.damping;
    for (std::size_t i = 0; i < shape.wheels.size(); ++i) model.wheelDamping[i] = shape.wheels[i].damping;
    const std::vector<double> loads = loadsOf(shape, objects, Vec2::Zero());
    for (std::size_t i = 0; i < shape.supports.size(); ++i) {
        const Support& s = shape.supports[i];
        model.supports[i] = {{s.centre.x(), s.centre.y(), s.centre.z()},
                             s.radius,
                             {s.way.x(), s.way.y()},
                             s.lever,
                             objects.friction(s.surface, objects.ground->surface()),
                             static_cast<int>(s.wheel),
                             s.round,
                             loads[i],
                             s.rolling};
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

/// How much of the pull of tilted gravity along the ground friction held in the last tick, from 0 of what rolls down to 1 of what holds or
/// drives up. `tilt`: in the vehicle's axes.
double heldShare(const WheeledObjects& objects, const WheeledUnit& unit, const Vec2& tilt) {
    double normal = 0, held = 0;
    for (std::size_t i = 0; i < unit.shape->supports.size(); ++i) {
        const SupportState& state = objects.supports[unit.supports + i];
        const Vec2& way = unit.shape->supports[i].way;
        normal += state.normal;
        held -= tilt.dot(state.along * way + state.across * Vec2(-way.y(), way.x()));
    }
    return normal > 0 ? std::clamp(held / (normal * tilt.squaredNorm()), 0., 1.) : 1;
}

/// What each support of a planar vehicle carries. The pull along the ground that friction holds leans on what is downhill.
void loadLoads(VehicleBlock& block, std::size_t lane, const WheeledObjects& objects, const WheeledUnit& unit) {
    const VehicleModel& model = objects.models[unit.model];
    std::vector<double> tilted;
    if (!objects.tilt.isZero(0)) {
        const Vec2 tilt = unit.plane.turnBack(objects.tilt);
        tilted = loadsOf(*unit.shape, objects, heldShare(objects, unit, tilt) * block.height[lane] * tilt);
    }
    for (int i = 0; i < model.supportCount; ++i)
        block.supports[i].load[lane] = tilted.empty() ? model.supports[i].load : tilted[static_cast<std::size_t>(i)];
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
    put(block.moment, lane, unit.moment + unit.rotation * unit.reaction);
    const VehicleModel& model = objects.models[unit.model];
    for (int i = 0; i < model.supportCount; ++i) {
        const SupportState& state = objects.supports[unit.supports + static_cast<std::uint32_t>(i)];
        VehicleSupportRow& row = block.supports[i];
        row.normal[lane] = state.normal;
        row.alongImpulse[lane] = state.along;
        row.acrossImpulse[lane] = state.across;
        row.cone[lane] = state.cone;
    }
    if (model.planar) loadLoads(block, lane, objects, unit);
    for (int i = 0; i < model.wheelCount; ++i)
        loadWheel(block.wheels[i], lane, objects.wheels[unit.wheels + static_cast<std::uint32_t>(i)]);
}

} // namespace

void loadVehicles(VehicleBlock& block, const WheeledObjects& objects, std::span<const std::uint32_t> units) {
    for (std::size_t lane = 0; lane < kVehicleLanes; ++lane)
        loadVehicle(block, lane, objects, units[std::min(lane, units.size() - 1)]);
}

void storeVehicle(const VehicleBlock& block, std::size_t lane, WheeledObjects& objects, std::uint32_t index, double h) {
    WheeledUnit& unit = objects.units[index];
    const VehicleModel& model = objects.models[unit.model];
    unit.position = vectorIn(block.position, lane);
    unit.rotation = {block.rotation[0][lane], block.rotation[1][lane], block.rotation[2][lane], block.rotation[3][lane]};
    unit.plane = {unit.position.head<2>(), block.c[lane], block.s[lane]};
    unit.linear = vectorIn(block.linear, lane);
    unit.angular = vectorIn(block.angular, lane);
    for (int i = 0; i < model.supportCount; ++i) {
        const VehicleSupportRow& row = block.supports[i];
        objects.supports[unit.supports + static_cast<std::uint32_t>(i)] = {row.keptNormal[lane], row.keptAlong[lane],
                                                                           row.keptAcross[lane], row.keptCone[lane]};
    }
    Vec3 spunUp = Vec3::Zero();
    for (int i = 0; i < model.wheelCount; ++i) {
        const VehicleWheelRow& row = block.wheels[i];
        WheelState& wheel = objects.wheels[unit.wheels + static_cast<std::uint32_t>(i)];
        spunUp += wheel.carried * (row.spin[lane] - wheel.spin) * unit.shape->wheels[static_cast<std::size_t>(i)].axis;
        wheel.spin = row.spin[lane];
        wheel.angle = row.angle[lane];
        wheel.impulse = row.impulse[lane];
        wheel.friction = row.friction[lane];
        wheel.halfCosine = row.halfCosine[lane];
        wheel.halfSine = row.halfSine[lane];
    }
    // Acts in the next tick, half of the rest in each one after that: loads that follow spins which follow loads do not swing.
    if (!model.planar) unit.reaction = (unit.reaction - spunUp / h) / 2;
}

void storeSpeeds(const VehicleBlock& block, std::size_t lane, WheeledUnit& unit) {
    const double c = block.middleC[lane], s = block.middleS[lane];
    const auto v = [&](int k) { return block.v[k][lane]; }; // vx, vy, wx, wy, wz, vz
    unit.linear = {c * v(0) - s * v(1), s * v(0) + c * v(1), v(5)};
    unit.angular = {c * v(2) - s * v(3), s * v(2) + c * v(3), v(4)};
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
