#pragma once
// What a motor gives a wheel in one tick, as a function of the wheel's angular momentum without it.
//
// Method: a motor is a line, torque = slope (rate - spin), between two limits; a servo is a steep line between the lines of the motor at
// full voltage forwards and backwards. Dry friction opposes the spin, and holds the wheel at rest. Each piece is linear in the spin at the
// end of the tick (implicit Euler), so the spin is linear in the momentum piece by piece, and falls nowhere.
// Included only by the files of the kernels; everything has internal linkage.

#include "world/wheeled/vehicle_lanes.h"

namespace trundle {
namespace {

constexpr double kSteep = 1e5; // of a motor row without softness: times the load that it moves
constexpr double kNoLimit = 1e300;

struct Piece {
    Lanes offset, mobility, inverse;
    [[nodiscard]] Lanes spin(Lanes momentum) const { return (momentum + offset) * mobility; }
};
inline Piece select(Mask m, const Piece& a, const Piece& b) {
    return {select(m, a.offset, b.offset), select(m, a.mobility, b.mobility), select(m, a.inverse, b.inverse)};
}
inline Piece load(const VehicleMotorPiece& p, int o) { return {load(p.offset + o), load(p.mobility + o), load(p.inverse + o)}; }
inline void store(VehicleMotorPiece& p, int o, const Piece& v) {
    store(p.offset + o, v.offset);
    store(p.mobility + o, v.mobility);
    store(p.inverse + o, v.inverse);
}

/// Spin of a wheel that nothing but its motor and its bearing holds.
struct FreeWheel {
    [[nodiscard]] Lanes spin(const Piece& piece, Lanes momentum) const { return piece.spin(momentum); }
};
/// Of one that does not slip: the mass of its tread moves with it.
struct GrippingWheel {
    Lanes tread; // inverse mass
    [[nodiscard]] Lanes spin(const Piece& piece, Lanes momentum) const { return piece.spin(momentum) * (tread * piece.inverse); }
};

/// Without dry friction: more spin is more torque at the same momentum.
template <class Wheel> inline Piece driven(const VehicleWheelRow& wheel, int o, Lanes momentum, const Wheel& grip) {
    Piece piece = load(wheel.line, o);
    Lanes spin = grip.spin(piece, momentum);
    for (const VehicleMotorPiece& limit : wheel.most) {
        const Piece p = load(limit, o);
        const Lanes at = grip.spin(p, momentum);
        piece = select(spin > at, p, piece);
        spin = least(spin, at);
    }
    for (const VehicleMotorPiece& limit : wheel.least) {
        const Piece p = load(limit, o);
        const Lanes at = grip.spin(p, momentum);
        piece = select(spin < at, p, piece);
        spin = most(spin, at);
    }
    return piece;
}

/// Where the motor cannot overcome its dry friction, the wheel rests. Whether it grips or not, its spin is a least and most of those of the
/// pieces, as their torque is: the right piece is found without a search.
template <class Wheel = FreeWheel>
inline Piece pieceAt(const VehicleWheelRow& wheel, int o, Lanes momentum, const Wheel& grip = {}) {
    const Piece plain = driven(wheel, o, momentum, grip);
    const Lanes dry = load(wheel.dryImpulse + o);
    if (!any(dry > 0.0)) return plain;
    Piece ahead = driven(wheel, o, momentum - dry, grip), back = driven(wheel, o, momentum + dry, grip);
    const Mask goesAhead = grip.spin(ahead, momentum - dry) > 0.0, goesBack = grip.spin(back, momentum + dry) < 0.0;
    ahead.offset -= dry;
    back.offset += dry;
    const Piece held = select(goesAhead, ahead, select(goesBack, back, load(wheel.still, o)));
    return select(dry > 0.0, held, plain);
}

/// `tread`: inverse mass of the tread along its way, without the wheel.
inline void prepareMotor(VehicleWheelRow& wheel, int o, double damping, double lever, double mobile, Lanes tread, double h) {
    const Lanes inertia = load(wheel.inertia + o), softness = load(wheel.softness + o), servo = load(wheel.damping + o);
    const Lanes hold = inertia + (damping + load(wheel.viscous + o)) * h, rest = 1 / hold;
    const Lanes limit = load(wheel.limit + o), rate = load(wheel.rate + o);
    const Mask limited = limit > 0.0, isServo = servo > 0.0;
    const auto piece = [&](Lanes offset, Lanes mobility) {
        return Piece{offset, mobility, 1 / (tread + lever * lever * mobility)};
    };
    const auto line = [&](Lanes slope, Lanes at) { return piece(slope * at, 1 / (hold + slope)); };
    const Lanes steep = kSteep * (inertia + mobile);
    const Mask stiff = isServo | (softness <= 0.0);
    const Lanes slope = select(stiff, steep, least(steep, h / select(stiff, all(1), softness)));
    const Lanes torque = select(limited, limit * h, all(kNoLimit));
    const Lanes full = limit / select(isServo, servo, all(1));
    const Piece high = piece(torque, rest), low = piece(-torque, rest);
    const Mask hasFull = limited & isServo;
    store(wheel.line, o, select(limited, line(slope, rate), piece(all(0), rest)));
    store(wheel.most[0], o, high);
    store(wheel.least[0], o, low);
    store(wheel.most[1], o, select(hasFull, line(servo * h, full), high));
    store(wheel.least[1], o, select(hasFull, line(servo * h, -full), low));
    store(wheel.still, o, piece(all(0), all(0)));
    store(wheel.rest + o, rest);
    store(wheel.dryImpulse + o, load(wheel.dry + o) * h);
}

} // namespace
} // namespace trundle
