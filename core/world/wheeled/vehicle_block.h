#pragma once
// Several equal vehicles in one tick, one in each lane: what the kernel of an instruction set reads and writes (vehicle_rows.h). The bits of a
// vehicle depend neither on the lanes beside it nor on the instruction set.
//
// Only plain numbers cross this header: a file that is compiled for newer instructions must share no inline function with others,
// because the linker keeps one copy of each for the whole program.

#include <cstdint>

namespace trundle {

inline constexpr int kVehicleLanes = 4;
inline constexpr int kVehicleRows = 24; ///< the most supports of a vehicle

using VehicleField = double[kVehicleLanes];

/// Shared by equal vehicles; vectors in the vehicle's axes.
struct VehicleModel {
    struct Support {
        double centre[3] = {}, radius = 0;
        double way[2] = {}, lever = 0, friction = 0; ///< as Support says; friction with the ground
        int wheel = 0;
        bool round = true;
        double load = 0;    ///< N, at rest where gravity is not tilted
        double rolling = 0; ///< as Support says
    };
    bool planar = false;                     ///< no motion but vx, vy and wz: inverseInertia has zz alone, loads do not change
    int supportCount = 0, wheelCount = 0;    ///< wheel i is at support i
    double mass = 1, inverseInertia[6] = {}; ///< xx, xy, xz, yy, yz, zz
    double stiffness = 0, damping = 0;
    double wheelDamping[kVehicleRows] = {};
    Support supports[kVehicleRows];
};

/// A linear piece of a motor's law: spin = (momentum + offset) * mobility; `inverse`: of what holds the tread along its way with it, kg.
struct VehicleMotorPiece {
    VehicleField offset, mobility, inverse;
};

/// A direction of friction.
struct VehicleWay {
    VehicleField x, y, arm[3], linear[2], angular[3]; ///< linear, angular: what an impulse changes
    VehicleField mass, inverse;                       ///< without the wheel: 1/kg, kg
};

struct VehicleSupportRow {
    VehicleField ax, ay, change[3], inverse, bias, normal; ///< of the normal: arm, change of the angular velocity; the impulse
    VehicleField load;                                     ///< of a planar vehicle: the force upwards, N
    VehicleWay way, across;
    VehicleField coupling, alongImpulse, acrossImpulse;
    VehicleField cone;     ///< what makes the impulse of a tread that slips as large as friction allows, 1/kg (ontoCone())
    VehicleField start[2]; ///< of a ball that turns freely: speeds of its middle after the last tick, along and across
    VehicleField keptNormal, keptAlong, keptAcross, keptCone;
};

struct VehicleWheelRow {
    VehicleField spin, angle, torque, inertia;                 ///< of its state
    VehicleField rate, softness, limit, damping, dry, viscous; ///< of its motor
    VehicleField rest, dryImpulse, momentum,
        keptMomentum;                  ///< rest: 1 / (inertia and damping over a tick); momentum: without the motor
    VehicleField impulse, friction;    ///< results, N m s
    VehicleField halfCosine, halfSine; ///< results: of half the angle
    VehicleMotorPiece line, most[2], least[2], still;
};

struct alignas(64) VehicleBlock {
    VehicleField position[3], height, rotation[4], c, s; ///< height: above the ground; rotation: w x y z; c, s: of the heading
    VehicleField linear[3], angular[3], force[3], moment[3];
    VehicleField v[6], keptV[6];               ///< vx, vy, wx, wy, wz, vz in the axes of the heading in the middle of the tick
    VehicleField middleC, middleS, inverse[6]; ///< of that heading; of the inertia in its axes
    double soft;                               ///< of the normals
    VehicleField change;                       ///< the largest of an impulse in the last sweep, N s
    VehicleSupportRow supports[kVehicleRows];
    VehicleWheelRow wheels[kVehicleRows];
};

/// Of a tick.
struct VehicleTick {
    double gravity[3] = {}, h = 0;
};

struct VehicleKernel {
    const char* name; ///< of the instruction set
    int lanes;
    /// Rows, and speeds with the impulses of the last tick.
    void (*prepare)(VehicleBlock& block, const VehicleModel& model, const VehicleTick& tick);
    /// The sweep with this number in the tick: every second one runs backwards.
    void (*sweep)(VehicleBlock& block, const VehicleModel& model, int number);
    /// Keeps what the chosen lanes have come to.
    void (*keep)(VehicleBlock& block, const VehicleModel& model, const bool* lanes);
    /// Sweeps each lane until it changes by less than `settled`, at most `sweeps` times, and keeps it.
    void (*settle)(VehicleBlock& block, const VehicleModel& model, double settled, int sweeps);
    /// From what was kept: states after the tick.
    void (*finish)(VehicleBlock& block, const VehicleModel& model, const VehicleTick& tick);
};

[[nodiscard]] const VehicleKernel& baselineVehicleKernel();
/// nullptr: not for this processor, or not compiled.
[[nodiscard]] const VehicleKernel* avx2VehicleKernel();
/// The fastest one for this processor.
[[nodiscard]] const VehicleKernel& vehicleKernel();

} // namespace trundle
