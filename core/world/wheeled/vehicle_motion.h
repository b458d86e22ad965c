#pragma once
// States after a tick, and the functions of a kernel.
// Included only by the files of the kernels; everything has internal linkage.

#include "world/wheeled/vehicle_sweeps.h"

namespace trundle {
namespace {

/// Sine and cosine by their series: the same on every machine.
inline void turnWheel(VehicleWheelRow& wheel, int o) {
    constexpr double kPi = 3.141592653589793238, kTurns = 4 * kPi; // of the half angle: one turn
    const Lanes angle = load(wheel.angle + o), half = (angle - kTurns * whole(angle * (1 / kTurns))) * 0.25, square = half * half;
    Lanes sine = all(1), cosine = all(1);
    for (int k = 19; k > 1; k -= 2) {
        sine = 1 - square * (1.0 / (k * (k - 1))) * sine;
        cosine = 1 - square * (1.0 / ((k - 1) * (k - 2))) * cosine;
    }
    sine *= half;
    store(wheel.halfSine + o, 2 * sine * cosine); // doubled
    store(wheel.halfCosine + o, cosine * cosine - sine * sine);
}

inline void finishWheel(VehicleWheelRow& wheel, int o, double h) {
    const Lanes momentum = load(wheel.keptMomentum + o), dry = load(wheel.dryImpulse + o), rest = load(wheel.rest + o);
    const Lanes spin = pieceAt(wheel, o, momentum).spin(momentum), both = spin / rest - momentum;
    Lanes motor = both;
    if (any(dry > 0.0)) {
        const Lanes limit = load(wheel.most[0].offset + o), wanted = load(wheel.line.offset + o);
        const Lanes held = most(least(wanted, limit), -limit);
        motor = select(dry > 0.0, select(spin > 0.0, both + dry, select(spin < 0.0, both - dry, held)), both);
    }
    store(wheel.spin + o, spin);
    store(wheel.impulse + o, motor);
    store(wheel.friction + o, both - motor - h * load(wheel.viscous + o) * spin);
    store(wheel.angle + o, load(wheel.angle + o) + h * spin);
    turnWheel(wheel, o);
}

/// The turn is exact to the fifth order of its angle.
inline void turn(VehicleBlock& b, int o, const Lanes3& w, double h) {
    const Lanes q0 = load(b.rotation[0] + o), q1 = load(b.rotation[1] + o), q2 = load(b.rotation[2] + o),
                q3 = load(b.rotation[3] + o);
    const Lanes scale = h / 2 * (1 + h * h / 12 * dot(w, w)); // tan(x/2) = x/2 (1 + x^2/12 ...)
    const Lanes3 t{scale * w.x, scale * w.y, scale * w.z};
    Lanes n[4] = {q0 - (t.x * q1 + t.y * q2 + t.z * q3), q1 + (t.x * q0 + t.y * q3 - t.z * q2),
                  q2 + (t.y * q0 + t.z * q1 - t.x * q3), q3 + (t.z * q0 + t.x * q2 - t.y * q1)};
    const Lanes scaleBack = 1 / root(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] + n[3] * n[3]);
    for (int k = 0; k < 4; ++k) n[k] *= scaleBack;
    const Mask turns = dot(w, w) > 0.0;
    for (int k = 0; k < 4; ++k) n[k] = select(turns, n[k], load(b.rotation[k] + o));
    for (int k = 0; k < 4; ++k) store(b.rotation[k] + o, n[k]);
    const Lanes c = n[0] * n[0] + n[1] * n[1] - n[2] * n[2] - n[3] * n[3], s = 2 * (n[1] * n[2] + n[0] * n[3]),
                l = root(c * c + s * s);
    store(b.c + o, c / l);
    store(b.s + o, s / l);
}

inline void finishLanes(VehicleBlock& b, int o, const VehicleModel& m, const VehicleTick& t) {
    const Lanes c = load(b.middleC + o), s = load(b.middleS + o);
    Lanes v[6];
    for (int k = 0; k < 6; ++k) v[k] = load(b.keptV[k] + o);
    const Lanes linear[3] = {c * v[VX] - s * v[VY], s * v[VX] + c * v[VY], v[VZ]};
    const Lanes angular[3] = {c * v[WX] - s * v[WY], s * v[WX] + c * v[WY], v[WZ]};
    for (int k = 0; k < 3; ++k) {
        store(b.linear[k] + o, linear[k]);
        store(b.angular[k] + o, angular[k]);
        store(b.position[k] + o, load(b.position[k] + o) + t.h * linear[k]);
    }
    for (int i = 0; i < m.wheelCount; ++i) finishWheel(b.wheels[i], o, t.h);
    turn(b, o, {angular[0], angular[1], angular[2]}, t.h);
}

void prepareBlock(VehicleBlock& b, const VehicleModel& m, const VehicleTick& t) {
    b.soft = 1 / (t.h * (t.h * m.stiffness + m.damping));
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) prepareLanes(b, o, m, t);
}
void sweepBlock(VehicleBlock& b, const VehicleModel& m, int number) {
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) sweepLanes(b, o, m, number);
}
void keepBlock(VehicleBlock& b, const VehicleModel& m, const bool* lanes) {
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) {
        Mask chosen{};
        for (int i = 0; i < TRUNDLE_LANES; ++i) chosen[i] = lanes[o + i] ? -1 : 0;
        keepLanes(b, o, m, chosen);
    }
}
void settleBlock(VehicleBlock& b, const VehicleModel& m, double settled, int sweeps) {
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) settleLanes(b, o, m, settled, sweeps);
}
void finishBlock(VehicleBlock& b, const VehicleModel& m, const VehicleTick& t) {
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) finishLanes(b, o, m, t);
}

} // namespace
} // namespace trundle
