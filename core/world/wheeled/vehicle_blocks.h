#pragma once
// Vehicles of the world into the lanes of blocks and back, and what contacts do to them there.

#include <span>

#include "world/wheeled/vehicle_block.h"
#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// Friction is that with the ground; it changes with the surfaces.
[[nodiscard]] VehicleModel vehicleModel(const ActorShape& shape, const WheeledObjects& objects);

/// Vehicles of one model, at most kVehicleLanes. Lanes left over repeat the last of them.
void loadVehicles(VehicleBlock& block, const WheeledObjects& objects, std::span<const std::uint32_t> units);
/// The state of one lane after the tick.
void storeVehicle(const VehicleBlock& block, std::size_t lane, WheeledObjects& objects, std::uint32_t unit, double h);

/// Its velocities alone, from those in the lane.
void storeSpeeds(const VehicleBlock& block, std::size_t lane, WheeledUnit& unit);

/// Speed of a point of the vehicle along a level direction, and what an impulse there does.
struct VehiclePush {
    alignas(16) double row[6] = {}, change[6] = {}; ///< vx, vy, wx, wy, wz, and a zero
};
/// Of a point of a contact: along its normal, and across that to the left.
struct VehiclePushes {
    VehiclePush normal, tangent;
};
/// Vectors from the centre of mass, world axes.
[[nodiscard]] VehiclePushes pushesAt(const VehicleBlock& block, std::size_t lane, double mass, const Vec3& arm,
                                     const Vec2& normal);

} // namespace trundle
