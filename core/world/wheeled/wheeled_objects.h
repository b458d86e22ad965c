#pragma once
// What is in the wheeled engine, in flat arrays that its parts share. Everything that moves or is fixed as a whole is a unit; units are
// numbered as they were added, with those that are scenery last.

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "world/engine.h"
#include "world/rays/ray_scene.h"
#include "world/wheeled/actor_shape.h"
#include "world/wheeled/vehicle_block.h"

namespace trundle {

inline constexpr std::size_t kUnitsOfThread = 16; ///< the fewest that a thread takes

/// Of the last tick, with which the next one starts.
struct SupportState {
    double normal = 0, along = 0, across = 0; ///< impulses, N s
    double cone = 0;                          ///< of friction at its limit, 1/kg
};

struct WheelState {
    double spin = 0, angle = 0;          ///< rad/s, rad, relative to the vehicle
    double halfCosine = 1, halfSine = 0; ///< of half the angle
    double impulse = 0;                  ///< of the motor in the last tick, N m s
    MotorConstraint motor;
    double torque = 0;   ///< of devices for one tick, N m
    double inertia = 0;  ///< kg m^2
    double carried = 0;  ///< kg m^2: its angular momentum over its spin, with that of its motor's rotor
    double friction = 0; ///< of the motor's drive in the last tick, N m s

    void stop() { spin = impulse = friction = 0; }
};

/// One of the world's actors: its state is that of its centre of mass.
struct WheeledUnit {
    std::shared_ptr<const ActorShape> shape;
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();
    Vec3 linear = Vec3::Zero(), angular = Vec3::Zero();
    Vec3 force = Vec3::Zero(), moment = Vec3::Zero(); ///< on it for one tick, N, N m
    Vec3 reaction = Vec3::Zero();                     ///< of a vehicle: moment of its wheels as they spin up, in its axes, N m
    Vec3 grip = Vec3::Zero(); ///< of something loose: impulse of its ground, x, y, and turning over spinRadius
    std::uint32_t bodies = 0, geoms = 0, joints = 0; ///< the first of each
    std::uint32_t supports = 0, wheels = 0;          ///< the first of each
    std::uint32_t model = 0;                         ///< of a vehicle
    PlanarPose plane;                                ///< of the axes of the shape
    bool ended = false;

    [[nodiscard]] bool isVehicle() const { return shape->kind == ActorKind::Vehicle; }
    [[nodiscard]] bool isMovable() const { return shape->kind != ActorKind::Fixed && !ended; }
    void setPlane() {
        const double w = rotation.w(), x = rotation.x(), y = rotation.y(), z = rotation.z();
        const double c = w * w + x * x - y * y - z * z, s = 2 * (x * y + w * z), n = std::sqrt(c * c + s * s);
        plane = {position.head<2>(), c / n, s / n};
    }
};

struct WheeledScenery {
    PlanarShape footprint; ///< in the world
    std::uint32_t geom = 0;
};

struct WheeledGeom {
    std::uint32_t body = kNoGeom; ///< none for scenery
    RayGeom ray;                  ///< centre and axes in the body's frame; in the world for scenery
};

struct WheeledObjects {
    std::vector<SurfaceSpec> surfaces;
    std::optional<LevelGround> ground;
    double weight = 0;        ///< of 1 kg on the ground, N
    Vec2 tilt = Vec2::Zero(); ///< of gravity: its level part over the other
    bool planar = false; ///< vehicles keep their height and do not lean
    std::vector<WheeledUnit> units;
    std::vector<VehicleModel> models; ///< one for each shape
    std::vector<WheeledScenery> scenery;
    std::vector<SupportState> supports;
    std::vector<WheelState> wheels;
    std::vector<WheeledGeom> geoms;
    std::vector<std::uint32_t> unitOf; ///< by body
    std::vector<std::uint32_t>
        aloft; ///< by geom: the vehicle whose geom it is and that does not touch the ground with it; else kNoActor
    std::vector<std::uint32_t> wheelOf; ///< by joint: index of its state, kNoGeom for one that is rigid
    std::vector<BodyState> states;      ///< of bodies, as published last

    [[nodiscard]] std::string engineName() const { return planar ? "Engine = planar" : "Engine = wheeled"; }
    [[nodiscard]] double friction(std::uint32_t a, std::uint32_t b) const {
        return std::min(surfaces[a].friction, surfaces[b].friction);
    }
};

} // namespace trundle
