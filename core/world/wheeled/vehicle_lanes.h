// Vehicles in the lanes of vector registers: TRUNDLE_LANES at once, all operations element by element. Included only by the files of the
// kernels; everything has internal linkage.
//
// Method: one rigid body with six degrees of freedom and the spin of each wheel, in the axes of its heading. Each support has a soft normal
//   row; friction and the motor of a wheel are one block, solved exactly inside the friction cone. Rows start with the impulses of the last
//   tick. Every second sweep runs backwards, so that left and right are treated alike.

#include "world/wheeled/vehicle_block.h"

namespace trundle {
namespace {

using Lanes = double __attribute__((vector_size(TRUNDLE_LANES * 8)));
using Mask = decltype(Lanes{} < Lanes{});

constexpr double kLeast = 1e-12;
constexpr double kCorrectingSpeed = 0.1; // m/s
constexpr int kConeSteps = 3, kPieceSteps = 3;
constexpr double kSteep = 1e5; // of a motor row without softness: times the load that it moves
constexpr double kNoLimit = 1e300;

enum { VX, VY, WX, WY, WZ, VZ };

inline Lanes all(double x) { return Lanes{} + x; }
inline Lanes select(Mask m, Lanes a, Lanes b) { return m ? a : b; }
inline Lanes least(Lanes a, Lanes b) { return b < a ? b : a; }
inline Lanes most(Lanes a, Lanes b) { return a < b ? b : a; }
inline Lanes size(Lanes a) { return select(a < 0.0, -a, a); }
inline Lanes root(Lanes a) {
    for (int i = 0; i < TRUNDLE_LANES; ++i) a[i] = __builtin_sqrt(a[i]);
    return a;
}
inline bool any(Mask m) {
    bool found = false;
    for (int i = 0; i < TRUNDLE_LANES; ++i) found = found || m[i];
    return found;
}
inline Lanes load(const double* p) {
    Lanes v;
    __builtin_memcpy(&v, p, sizeof v);
    return v;
}
inline void store(double* p, Lanes v) { __builtin_memcpy(p, &v, sizeof v); }
/// To the nearest whole number, for sizes up to 2^51.
inline Lanes whole(Lanes a) {
    constexpr double kShift = 6755399441055744.0; // 1.5 * 2^52
    return (a + kShift) - kShift;
}

struct Lanes3 {
    Lanes x, y, z;
};
inline Lanes dot(const Lanes3& a, const Lanes3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
struct Symmetric {
    Lanes xx, xy, xz, yy, yz, zz;
};
inline Lanes3 times(const Symmetric& m, const Lanes3& v) {
    return {m.xx * v.x + m.xy * v.y + m.xz * v.z, m.xy * v.x + m.yy * v.y + m.yz * v.z, m.xz * v.x + m.yz * v.y + m.zz * v.z};
}
struct Axes {
    Lanes3 x, y, z; // rows
};
inline Lanes3 times(const Axes& m, const Lanes3& v) { return {dot(m.x, v), dot(m.y, v), dot(m.z, v)}; }

inline Axes axesOf(Lanes w, Lanes x, Lanes y, Lanes z) {
    return {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
            {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
            {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
}

// ---- the law of a motor ----

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

/// Without dry friction: more spin is more torque at the same momentum.
inline Piece driven(const VehicleWheelRow& wheel, int o, Lanes momentum) {
    Piece piece = load(wheel.line, o);
    Lanes spin = piece.spin(momentum);
    for (const VehicleMotorPiece& limit : wheel.most) {
        const Piece p = load(limit, o);
        const Lanes at = p.spin(momentum);
        piece = select(spin > at, p, piece);
        spin = least(spin, at);
    }
    for (const VehicleMotorPiece& limit : wheel.least) {
        const Piece p = load(limit, o);
        const Lanes at = p.spin(momentum);
        piece = select(spin < at, p, piece);
        spin = most(spin, at);
    }
    return piece;
}

/// Where the motor cannot overcome its dry friction, the wheel rests.
inline Piece pieceAt(const VehicleWheelRow& wheel, int o, Lanes momentum) {
    const Piece plain = driven(wheel, o, momentum);
    const Lanes dry = load(wheel.dryImpulse + o);
    if (!any(dry > 0.0)) return plain;
    Piece ahead = driven(wheel, o, momentum - dry), back = driven(wheel, o, momentum + dry);
    const Mask goesAhead = ahead.spin(momentum - dry) > 0.0, goesBack = back.spin(momentum + dry) < 0.0;
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

// ---- rows ----

inline Symmetric inverseInertia(const VehicleModel& m, const Axes& a) {
    const double* i = m.inverseInertia;
    const auto row = [i](const Lanes3& r) {
        return Lanes3{r.x * i[0] + r.y * i[1] + r.z * i[2], r.x * i[1] + r.y * i[3] + r.z * i[4],
                      r.x * i[2] + r.y * i[4] + r.z * i[5]};
    };
    const Lanes3 x = row(a.x), y = row(a.y), z = row(a.z);
    return {dot(x, a.x), dot(x, a.y), dot(x, a.z), dot(y, a.y), dot(y, a.z), dot(z, a.z)};
}

inline void prepareWay(VehicleWay& way, int o, const Symmetric& inverse, const Lanes3& arm, Lanes x, Lanes y,
                       double inverseMass) {
    const Lanes3 turn{-arm.z * y, arm.z * x, arm.x * y - arm.y * x}, change = times(inverse, turn);
    const Lanes mass = inverseMass + dot(turn, change);
    store(way.x + o, x);
    store(way.y + o, y);
    store(way.arm[0] + o, turn.x);
    store(way.arm[1] + o, turn.y);
    store(way.arm[2] + o, turn.z);
    store(way.linear[0] + o, inverseMass * x);
    store(way.linear[1] + o, inverseMass * y);
    store(way.angular[0] + o, change.x);
    store(way.angular[1] + o, change.y);
    store(way.angular[2] + o, change.z);
    store(way.mass + o, mass);
    store(way.inverse + o, 1 / mass);
}

inline Lanes speed(const VehicleWay& way, int o, const Lanes* v) {
    return load(way.x + o) * v[VX] + load(way.y + o) * v[VY] +
           (load(way.arm[0] + o) * v[WX] + load(way.arm[1] + o) * v[WY] + load(way.arm[2] + o) * v[WZ]);
}
inline void apply(const VehicleWay& way, int o, Lanes impulse, Lanes* v) {
    v[VX] += impulse * load(way.linear[0] + o);
    v[VY] += impulse * load(way.linear[1] + o);
    for (int k = 0; k < 3; ++k) v[WX + k] += impulse * load(way.angular[k] + o);
}

/// The middle of the tick: wheels go round a circle and not along its tangents.
inline void setMiddle(VehicleBlock& b, int o, double h) {
    const Lanes c = load(b.c + o), s = load(b.s + o), t = h / 4 * load(b.angular[2] + o), n = 1 / (1 + t * t);
    const Lanes dc = (1 - t * t) * n, ds = 2 * t * n;
    store(b.middleC + o, c * dc - s * ds);
    store(b.middleS + o, s * dc + c * ds);
}

/// Of the vehicle in those of its heading.
inline Axes headingAxes(const VehicleBlock& b, int o) {
    const Lanes c = load(b.c + o), s = load(b.s + o);
    const Axes a = axesOf(load(b.rotation[0] + o), load(b.rotation[1] + o), load(b.rotation[2] + o), load(b.rotation[3] + o));
    return {{c * a.x.x + s * a.y.x, c * a.x.y + s * a.y.y, c * a.x.z + s * a.y.z},
            {c * a.y.x - s * a.x.x, c * a.y.y - s * a.x.y, c * a.y.z - s * a.x.z},
            a.z};
}

inline void startSpeeds(const VehicleBlock& b, int o, const VehicleModel& m, const VehicleTick& t, const Symmetric& inverse,
                        Lanes* v) {
    const double h = t.h, push = h / m.mass;
    const Lanes c = load(b.middleC + o), s = load(b.middleS + o);
    const auto with = [&](int k) { return load(b.linear[k] + o) + h * t.gravity[k] + push * load(b.force[k] + o); };
    const Lanes x = with(0), y = with(1), wx = load(b.angular[0] + o), wy = load(b.angular[1] + o);
    const Lanes mx = load(b.moment[0] + o), my = load(b.moment[1] + o);
    const Lanes3 turn = times(inverse, {c * mx + s * my, c * my - s * mx, load(b.moment[2] + o)});
    v[VX] = c * x + s * y;
    v[VY] = c * y - s * x;
    v[VZ] = with(2);
    v[WX] = c * wx + s * wy + h * turn.x;
    v[WY] = c * wy - s * wx + h * turn.y;
    v[WZ] = load(b.angular[2] + o) + h * turn.z;
}

inline void prepareNormal(VehicleSupportRow& row, int o, const VehicleModel& m, const Symmetric& inverse, const Lanes3& arm,
                          Lanes depth, double h, Lanes* v) {
    const double stiff = h * m.stiffness + m.damping, soft = 1 / (h * stiff), share = h * m.stiffness / stiff;
    const Lanes3 change = times(inverse, {arm.y, -arm.x, all(0)});
    const Lanes impulse = load(row.normal + o);
    store(row.ax + o, arm.x);
    store(row.ay + o, arm.y);
    store(row.change[0] + o, change.x);
    store(row.change[1] + o, change.y);
    store(row.change[2] + o, change.z);
    store(row.inverse + o, 1 / (1 / m.mass + arm.y * change.x - arm.x * change.y + soft));
    store(row.bias + o, select(depth > 0.0, least(share * depth, all(kCorrectingSpeed * h)), depth) / h);
    v[VZ] += impulse * (1 / m.mass);
    v[WX] += impulse * change.x;
    v[WY] += impulse * change.y;
    v[WZ] += impulse * change.z;
}

/// The way is that in the axes of the heading, along the ground.
inline void prepareFriction(VehicleSupportRow& row, int o, const VehicleModel::Support& s, const Symmetric& inverse,
                            const Axes& axes, const Lanes3& arm, double inverseMass, Lanes* v) {
    const Lanes x = axes.x.x * s.way[0] + axes.x.y * s.way[1], y = axes.y.x * s.way[0] + axes.y.y * s.way[1];
    const Lanes scale = 1 / root(x * x + y * y);
    prepareWay(row.way, o, inverse, arm, x * scale, y * scale, inverseMass);
    prepareWay(row.across, o, inverse, arm, -y * scale, x * scale, inverseMass);
    Lanes coupling = all(0);
    for (int k = 0; k < 3; ++k) coupling += load(row.way.arm[k] + o) * load(row.across.angular[k] + o);
    store(row.coupling + o, coupling);
    apply(row.way, o, load(row.alongImpulse + o), v);
    if (s.round) apply(row.across, o, load(row.acrossImpulse + o), v);
}

inline void prepareLanes(VehicleBlock& b, int o, const VehicleModel& m, const VehicleTick& t) {
    const double h = t.h, inverseMass = 1 / m.mass;
    const Axes axes = headingAxes(b, o);
    setMiddle(b, o, h);
    const Symmetric inverse = inverseInertia(m, axes);
    const Lanes parts[6] = {inverse.xx, inverse.xy, inverse.xz, inverse.yy, inverse.yz, inverse.zz};
    for (int k = 0; k < 6; ++k) store(b.inverse[k] + o, parts[k]);
    Lanes v[6];
    startSpeeds(b, o, m, t, inverse, v);
    const Lanes height = load(b.height + o);
    for (int i = 0; i < m.supportCount; ++i) {
        const VehicleModel::Support& s = m.supports[i];
        VehicleSupportRow& row = b.supports[i];
        const Lanes3 centre = times(axes, {all(s.centre[0]), all(s.centre[1]), all(s.centre[2])});
        const Lanes3 arm{centre.x, centre.y, centre.z - s.radius};
        prepareNormal(row, o, m, inverse, arm, s.radius - (height + centre.z), h, v);
        if (s.friction > 0) prepareFriction(row, o, s, inverse, axes, arm, inverseMass, v);
    }
    for (int i = 0; i < m.wheelCount; ++i) {
        const VehicleModel::Support& s = m.supports[i];
        VehicleWheelRow& wheel = b.wheels[i];
        const bool grips = s.friction > 0 && s.lever != 0;
        prepareMotor(wheel, o, m.wheelDamping[i], grips ? s.lever : 0, m.mass * s.radius * s.radius,
                     grips ? load(b.supports[i].way.mass + o) : all(1), h);
        Lanes momentum = load(wheel.inertia + o) * load(wheel.spin + o) + h * load(wheel.torque + o);
        if (grips) momentum -= s.lever * load(b.supports[i].alongImpulse + o);
        store(wheel.momentum + o, momentum);
    }
    for (int k = 0; k < 6; ++k) store(b.v[k] + o, v[k]);
}

// ---- sweeps ----

inline Lanes solveNormal(VehicleSupportRow& row, int o, double soft, double inverseMass, Lanes* v) {
    const Lanes impulse = load(row.normal + o);
    const Lanes rises = v[VZ] + (load(row.ay + o) * v[WX] - load(row.ax + o) * v[WY]);
    const Lanes change = most((load(row.bias + o) - soft * impulse - rises) * load(row.inverse + o), -impulse);
    store(row.normal + o, impulse + change);
    v[VZ] += change * inverseMass;
    for (int k = 0; k < 3; ++k) v[WX + k] += change * load(row.change[k] + o);
    return size(change);
}

/// The impulse inside the circle of radius `limit` that opposes the slip left over: (k + a) l = b, |l| = limit. Newton on 1/|l|.
inline void ontoCone(Lanes& along, Lanes& across, Lanes k1, Lanes k2, Lanes b1, Lanes b2, Lanes limit) {
    const Lanes radius = most(limit, all(kLeast)), tiny = all(kLeast * kLeast);
    Lanes add = all(0), x = b1 / k1, y = b2 / k2, square = x * x + y * y;
    for (int i = 0; i < kConeSteps; ++i) {
        const Lanes length = root(most(square, tiny)), slope = x * x / (k1 + add) + y * y / (k2 + add);
        add = most(add + (length / radius - 1) * square / most(slope, tiny), all(0));
        x = b1 / (k1 + add);
        y = b2 / (k2 + add);
        square = x * x + y * y;
    }
    const Lanes scale = least(radius / root(most(square, tiny)), all(1));
    along = x * scale;
    across = y * scale;
}

/// The change of the impulse along after which the tread does not slip, with the motor's answer; `inverse`: of the mass of both.
inline Lanes solveAlong(const VehicleSupportRow& row, const VehicleWheelRow* wheel, int o, double lever, Lanes slip,
                        Lanes& inverse) {
    inverse = load(row.way.inverse + o);
    if (!wheel) return -slip * inverse;
    const Lanes momentum = load(wheel->momentum + o);
    Piece piece = pieceAt(*wheel, o, momentum);
    Lanes change = all(0);
    for (int again = 0; again < kPieceSteps; ++again) {
        inverse = piece.inverse;
        change = (lever * piece.spin(momentum) - slip) * inverse;
        const Piece next = pieceAt(*wheel, o, momentum - lever * change);
        if (!any((next.offset != piece.offset) | (next.mobility != piece.mobility))) break; // the same again for all
        piece = next;
    }
    return change;
}

inline Lanes solveFriction(VehicleSupportRow& row, VehicleWheelRow* wheel, int o, const VehicleModel::Support& s, Lanes* v) {
    const Lanes limit = s.friction * load(row.normal + o), before = load(row.alongImpulse + o);
    Lanes inverse, along = solveAlong(row, wheel, o, s.lever, speed(row.way, o, v), inverse), across = all(0);
    if (s.round) {
        const Lanes slip = speed(row.across, o, v), beforeAcross = load(row.acrossImpulse + o), mass = load(row.across.mass + o);
        across = (-slip - load(row.coupling + o) * along) * load(row.across.inverse + o);
        const Lanes x = before + along, y = beforeAcross + across;
        if (const Mask slips = x * x + y * y > limit * limit; any(slips)) {
            Lanes to, toAcross;
            const Lanes both = 1 / inverse;
            ontoCone(to, toAcross, both, mass, both * x, mass * beforeAcross - slip, limit);
            along = select(slips, to - before, along);
            across = select(slips, toAcross - beforeAcross, across);
        }
        store(row.acrossImpulse + o, beforeAcross + across);
        apply(row.across, o, across, v);
    } else along = most(least(before + along, limit), -limit) - before;
    store(row.alongImpulse + o, before + along);
    apply(row.way, o, along, v);
    if (wheel) store(wheel->momentum + o, load(wheel->momentum + o) - s.lever * along);
    return most(size(along), size(across));
}

inline void sweepLanes(VehicleBlock& b, int o, const VehicleModel& m, bool backwards) {
    Lanes v[6], change = all(0);
    for (int k = 0; k < 6; ++k) v[k] = load(b.v[k] + o);
    const double inverseMass = 1 / m.mass, soft = b.soft;
    const int count = m.supportCount;
    for (int q = 0; q < count; ++q)
        change = most(change, solveNormal(b.supports[backwards ? count - 1 - q : q], o, soft, inverseMass, v));
    for (int q = 0; q < count; ++q) {
        const int i = backwards ? count - 1 - q : q;
        const VehicleModel::Support& s = m.supports[i];
        if (s.friction > 0)
            change = most(change, solveFriction(b.supports[i], s.lever != 0 ? &b.wheels[s.wheel] : nullptr, o, s, v));
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
    }
    for (int i = 0; i < m.wheelCount; ++i) keep(b.wheels[i].keptMomentum, b.wheels[i].momentum);
}

inline void settleLanes(VehicleBlock& b, int o, const VehicleModel& m, double settled, int sweeps) {
    Mask open = all(0) == all(0);
    for (int i = 0; i < sweeps && any(open); ++i) {
        sweepLanes(b, o, m, i % 2 != 0);
        if (i == 0) continue;
        const Mask now = open & (load(b.change + o) < settled);
        if (any(now)) keepLanes(b, o, m, now);
        open = open & ~now;
    }
    if (any(open)) keepLanes(b, o, m, open);
}

// ---- results ----

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

// ---- the table ----

void prepareBlock(VehicleBlock& b, const VehicleModel& m, const VehicleTick& t) {
    b.soft = 1 / (t.h * (t.h * m.stiffness + m.damping));
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) prepareLanes(b, o, m, t);
}
void sweepBlock(VehicleBlock& b, const VehicleModel& m, bool backwards) {
    for (int o = 0; o < kVehicleLanes; o += TRUNDLE_LANES) sweepLanes(b, o, m, backwards);
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
