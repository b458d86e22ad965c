#pragma once
// Sweeps of a Gauss-Seidel solver over the rows. Every second sweep runs backwards, so that left and right are treated alike.
// Included only by the files of the kernels; everything has internal linkage.

#include "world/wheeled/vehicle_rows.h"

namespace trundle {
namespace {

constexpr double kLeast = 1e-12;
constexpr int kWholeSteps = 12; // sweeps: friction at its limit takes half steps after them

inline Lanes solveNormal(VehicleSupportRow& row, int o, double soft, double inverseMass, Lanes* v) {
    const Lanes impulse = load(row.normal + o);
    const Lanes rises = v[VZ] + (load(row.ay + o) * v[WX] - load(row.ax + o) * v[WY]);
    const Lanes change = most((load(row.bias + o) - soft * impulse - rises) * load(row.inverse + o), -impulse);
    store(row.normal + o, impulse + change);
    v[VZ] += change * inverseMass;
    for (int k = 0; k < 3; ++k) v[WX + k] += change * load(row.change[k] + o);
    return size(change);
}

/// From the impulse that would end the slip to the one on the circle of radius `limit` that opposes the slip left over: (k + add) l = b,
/// |l| = limit, for 1/k = i1, i2. One step of Newton's method on 1/|l| for each sweep: `add` is that of the last one, and what its
/// solution misses is scaled away. It starts from at most |b| / limit, the solution for k = 0: `add` is much larger where the support
/// carried next to nothing, and would take one sweep after another to come down.
inline void ontoCone(Lanes& along, Lanes& across, Lanes& add, Lanes i1, Lanes i2, Lanes limit) {
    const Mask none = limit < kLeast;
    const Lanes radius = most(limit, all(kLeast)), tiny = all(kLeast * kLeast), bx = along / i1, by = across / i2;
    add = least(add, root(bx * bx + by * by) / radius);
    const Lanes w1 = 1 + add * i1, w2 = 1 + add * i2, both = 1 / (w1 * w2);
    const Lanes x = along * (w2 * both), y = across * (w1 * both), square = most(x * x + y * y, tiny), length = root(square);
    const Lanes slope = (x * x * i1 * w2 + y * y * i2 * w1) * both, scale = radius / length;
    add = select(none, all(0), most(add + (length - radius) * square / (radius * most(slope, tiny)), all(0)));
    along = select(none, all(0), x * scale);
    across = select(none, all(0), y * scale);
}

/// The change of the impulse along after which the tread does not slip, with the motor's answer; `inverse`: of the mass of both.
inline Lanes solveAlong(const VehicleSupportRow& row, const VehicleWheelRow* wheel, int o, double lever, Lanes slip,
                        Lanes& inverse) {
    inverse = load(row.way.inverse + o);
    if (!wheel) return -slip * inverse;
    const Lanes momentum = load(wheel->momentum + o), tread = load(row.way.mass + o);
    const Piece piece = pieceAt(*wheel, o, momentum + lever * slip * inverse, GrippingWheel{tread});
    inverse = piece.inverse;
    return (lever * piece.spin(momentum) - slip) * inverse;
}

/// Of a ball that turns freely (prepareRolling()).
inline Lanes solveRolling(VehicleSupportRow& row, int o, const VehicleModel::Support& s, Lanes* v) {
    const double give = 1 / s.rolling;
    const Lanes limit = s.friction * load(row.normal + o), x = load(row.alongImpulse + o), y = load(row.acrossImpulse + o);
    const Lanes along = (load(row.start[0] + o) - give * x - speed(row.way, o, v)) * load(row.way.inverse + o),
                slip = speed(row.across, o, v) + load(row.coupling + o) * along,
                across = (load(row.start[1] + o) - give * y - slip) * load(row.across.inverse + o);
    const Lanes square = (x + along) * (x + along) + (y + across) * (y + across);
    const Mask slips = square > limit * limit;
    const Lanes scale = select(slips, limit / root(select(slips, square, all(1))), all(1));
    const Lanes toAlong = scale * (x + along), toAcross = scale * (y + across);
    store(row.alongImpulse + o, toAlong);
    store(row.acrossImpulse + o, toAcross);
    apply(row.way, o, toAlong - x, v);
    apply(row.across, o, toAcross - y, v);
    return most(size(toAlong - x), size(toAcross - y));
}

/// `step`: the part of its change that friction at its limit makes.
inline Lanes solveFriction(VehicleSupportRow& row, VehicleWheelRow* wheel, int o, const VehicleModel::Support& s, double step,
                           Lanes* v) {
    const Lanes limit = s.friction * load(row.normal + o), before = load(row.alongImpulse + o);
    const Lanes free = speed(row.way, o, v);
    Lanes inverse, along = solveAlong(row, wheel, o, s.lever, free, inverse), across = all(0);
    if (s.round) {
        const Lanes slip = speed(row.across, o, v), beforeAcross = load(row.acrossImpulse + o);
        const Lanes inverseAcross = load(row.across.inverse + o);
        across = (-slip - load(row.coupling + o) * along) * inverseAcross;
        const Lanes x = before + along, y = beforeAcross + across;
        if (const Mask slips = x * x + y * y > limit * limit; any(slips)) {
            Lanes to = x, toAcross = beforeAcross - slip * inverseAcross, add = load(row.cone + o);
            if (wheel) { // the motor answers as it does at what the wheel carries, not at what would end the slip
                const Lanes momentum = load(wheel->momentum + o);
                const Piece now = pieceAt(*wheel, o, momentum);
                inverse = select(slips, now.inverse, inverse);
                to = select(slips, before + (s.lever * now.spin(momentum) - free) * now.inverse, to);
            }
            ontoCone(to, toAcross, add, inverse, inverseAcross, limit);
            store(row.cone + o, select(slips, add, load(row.cone + o)));
            along = select(slips, step * (to - before), along);
            across = select(slips, step * (toAcross - beforeAcross), across);
        }
        store(row.acrossImpulse + o, beforeAcross + across);
        apply(row.across, o, across, v);
    } else along = most(least(before + along, limit), -limit) - before;
    store(row.alongImpulse + o, before + along);
    apply(row.way, o, along, v);
    if (wheel) store(wheel->momentum + o, load(wheel->momentum + o) - s.lever * along);
    return most(size(along), size(across));
}

/// `number`: of the sweep in this tick. Loads that follow friction and friction that follows them may rise and fall for ever where the
/// centre of mass is high; in half steps they come to rest.
inline void sweepLanes(VehicleBlock& b, int o, const VehicleModel& m, int number) {
    const bool backwards = number % 2 != 0;
    const double step = number < kWholeSteps ? 1 : 0.5;
    Lanes v[6], change = all(0);
    for (int k = 0; k < 6; ++k) v[k] = load(b.v[k] + o);
    const double inverseMass = 1 / m.mass, soft = b.soft;
    const int count = m.supportCount;
    for (int q = 0; q < count && !m.planar; ++q)
        change = most(change, solveNormal(b.supports[backwards ? count - 1 - q : q], o, soft, inverseMass, v));
    for (int q = 0; q < count; ++q) {
        const int i = backwards ? count - 1 - q : q;
        const VehicleModel::Support& s = m.supports[i];
        if (s.friction > 0 && s.rolling > 0) change = most(change, solveRolling(b.supports[i], o, s, v));
        else if (s.friction > 0)
            change = most(change, solveFriction(b.supports[i], s.lever != 0 ? &b.wheels[s.wheel] : nullptr, o, s, step, v));
    }
    for (int k = 0; k < 6; ++k) store(b.v[k] + o, v[k]);
    store(b.change + o, change);
}

inline void keepLanes(VehicleBlock& b, int o, const VehicleModel& m, Mask chosen) {
    const auto keep = [&](double* kept, const double* now) { store(kept + o, select(chosen, load(now + o), load(kept + o))); };
    for (int k = 0; k < 6; ++k) keep(b.keptV[k], b.v[k]);
    for (int i = 0; i < m.supportCount; ++i) {
        VehicleSupportRow& row = b.supports[i];
        keep(row.keptNormal, row.normal);
        keep(row.keptAlong, row.alongImpulse);
        keep(row.keptAcross, row.acrossImpulse);
        keep(row.keptCone, row.cone);
    }
    for (int i = 0; i < m.wheelCount; ++i) keep(b.wheels[i].keptMomentum, b.wheels[i].momentum);
}

inline void settleLanes(VehicleBlock& b, int o, const VehicleModel& m, double settled, int sweeps) {
    Mask open = all(0) == all(0);
    for (int i = 0; i < sweeps && any(open); ++i) {
        sweepLanes(b, o, m, i);
        if (i == 0) continue;
        const Mask now = open & (load(b.change + o) < settled);
        if (any(now)) keepLanes(b, o, m, now);
        open = open & ~now;
    }
    if (any(open)) keepLanes(b, o, m, open);
}

} // namespace
} // namespace trundle
