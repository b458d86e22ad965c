#pragma once
// Rows of vehicles at the start of a tick.
//
// Method: one rigid body with six degrees of freedom and the spin of each wheel, in the axes of its heading. Each support has a soft normal
//   row; friction and the motor of a wheel are one block, solved exactly inside the friction cone. Rows start with the impulses of the last
//   tick.
// Included only by the files of the kernels; everything has internal linkage.

#include "world/wheeled/vehicle_motor.h"

namespace trundle {
namespace {

constexpr double kCorrectingSpeed = 0.1; // m/s

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
    v[VZ] = m.planar ? all(0) : with(2);
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

/// A ball that turns freely in its socket grips the ground and holds the vehicle at its middle, no more than by what its turning
/// takes: an impulse of `rolling` times the change of its speed. `before`: speeds after the last tick, since which its arm has turned.
inline void prepareRolling(VehicleSupportRow& row, int o, double rolling, const Lanes3& centre, const Lanes* before, double h) {
    const Lanes turned = h * before[WZ] * before[WZ];
    VehicleWay* ways[2] = {&row.way, &row.across};
    for (int k = 0; k < 2; ++k) {
        VehicleWay& way = *ways[k];
        store(way.inverse + o, 1 / (load(way.mass + o) + 1 / rolling));
        store(row.start[k] + o, speed(way, o, before) + turned * (load(way.x + o) * centre.x + load(way.y + o) * centre.y));
    }
}

/// After the last tick, in the axes of its heading.
inline void lastSpeeds(const VehicleBlock& b, int o, Lanes* v) {
    const Lanes c = load(b.middleC + o), s = load(b.middleS + o);
    const Lanes x = load(b.linear[0] + o), y = load(b.linear[1] + o), wx = load(b.angular[0] + o), wy = load(b.angular[1] + o);
    v[VX] = c * x + s * y;
    v[VY] = c * y - s * x;
    v[WX] = c * wx + s * wy;
    v[WY] = c * wy - s * wx;
    v[WZ] = load(b.angular[2] + o);
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
    Lanes before[6] = {};
    lastSpeeds(b, o, before);
    const Lanes height = load(b.height + o);
    for (int i = 0; i < m.supportCount; ++i) {
        const VehicleModel::Support& s = m.supports[i];
        VehicleSupportRow& row = b.supports[i];
        const Lanes3 centre = times(axes, {all(s.centre[0]), all(s.centre[1]), all(s.centre[2])});
        const Lanes3 arm{centre.x, centre.y, centre.z - s.radius};
        if (m.planar) store(row.normal + o, h * load(row.load + o));
        else prepareNormal(row, o, m, inverse, arm, s.radius - (height + centre.z), h, v);
        const bool rolls = s.rolling > 0;
        if (s.friction > 0) prepareFriction(row, o, s, inverse, axes, rolls ? centre : arm, inverseMass, v);
        if (s.friction > 0 && rolls) prepareRolling(row, o, s.rolling, centre, before, h);
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

} // namespace
} // namespace trundle
