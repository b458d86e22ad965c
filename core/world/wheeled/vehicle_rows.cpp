#include "world/wheeled/vehicle_rows.h"

#include <cmath>

namespace trundle {

namespace {

enum { VX, VY, WX, WY, WZ, VZ };

constexpr double kTiny = 1e-12;
constexpr double kCorrectingSpeed = 0.1; // m/s
constexpr int kConeSteps = 3;

/// The impulse inside the circle of radius `limit` that opposes the slip left over: (k + a) l = b, |l| = limit. Newton on 1/|l|.
void ontoCone(double& along, double& across, double k1, double k2, double b1, double b2, double limit) {
    const double radius = std::max(limit, kTiny);
    double add = 0, x = b1 / k1, y = b2 / k2, square = x * x + y * y;
    for (int i = 0; i < kConeSteps; ++i) {
        const double length = std::sqrt(std::max(square, kTiny * kTiny)), slope = x * x / (k1 + add) + y * y / (k2 + add);
        add = std::max(add + (length / radius - 1) * square / std::max(slope, kTiny * kTiny), 0.);
        x = b1 / (k1 + add);
        y = b2 / (k2 + add);
        square = x * x + y * y;
    }
    const double scale = std::min(radius / std::sqrt(std::max(square, kTiny * kTiny)), 1.);
    along = x * scale;
    across = y * scale;
}

} // namespace

/// Rows act along the heading in the middle of the tick, so that wheels go round a circle and not along its tangents.
void VehicleRows::setAxes(const WheeledUnit& unit) {
    const double c = unit.plane.c, s = unit.plane.s;
    Mat3 back;
    back << c, s, 0, -s, c, 0, 0, 0, 1;
    m_axes = back * unit.rotation.toRotationMatrix();
    const double t = m_h * unit.angular.z() / 4, n = 1 / (1 + t * t), dc = (1 - t * t) * n, ds = 2 * t * n; // half of the turn
    m_c = c * dc - s * ds;
    m_s = s * dc + c * ds;
    m_inverse = m_axes * m_shape->inertia.inverse() * m_axes.transpose();
}

void VehicleRows::prepare(const WheeledObjects& objects, std::uint32_t index, const Vec3& gravity, double h) {
    const WheeledUnit& unit = objects.units[index];
    m_shape = unit.shape.get();
    m_unit = index;
    m_h = h;
    m_inverseMass = 1 / m_shape->mass;
    setAxes(unit);
    const Vec3 v = unit.linear + h * (gravity + m_inverseMass * unit.force);
    const Vec3& w = unit.angular;
    m_v = {
        m_c * v.x() + m_s * v.y(), m_c * v.y() - m_s * v.x(), m_c * w.x() + m_s * w.y(), m_c * w.y() - m_s * w.x(), w.z(), v.z()};
    const Vec3 moment(m_c * unit.moment.x() + m_s * unit.moment.y(), m_c * unit.moment.y() - m_s * unit.moment.x(),
                      unit.moment.z());
    const Vec3 turn = h * (m_inverse * moment);
    for (int k = 0; k < 3; ++k) m_v[static_cast<std::size_t>(WX + k)] += turn[k];
    m_count = 0;
    addWheels(objects, unit, h);
    const double height = unit.position.z() - objects.ground->height;
    for (std::size_t i = 0; i < m_shape->supports.size(); ++i) {
        const Support& s = m_shape->supports[i];
        Normal& row = m_normals[m_count];
        const Vec3 centre = m_axes * s.centre;
        row.bias = s.radius - (height + centre.z()); // depth
        addSupport(s, objects.supports[unit.supports + i], objects.friction(s.surface, objects.ground->surface()), h);
    }
}

void VehicleRows::addWheels(const WheeledObjects& objects, const WheeledUnit& unit, double h) {
    m_wheelCount = m_shape->wheels.size();
    for (std::size_t i = 0; i < m_wheelCount; ++i) {
        const WheelState& wheel = objects.wheels[unit.wheels + i];
        const double radius = m_shape->supports[i].radius;
        m_motors[i] = MotorLaw(wheel, m_shape->wheels[i].damping, m_shape->mass * radius * radius, h);
        m_momenta[i] = wheel.inertia * wheel.spin + h * wheel.torque;
    }
}

VehicleRows::Way VehicleRows::wayOf(const Vec3& arm, double x, double y) const {
    Way way{x, y, {-arm.z() * y, arm.z() * x, arm.x() * y - arm.y() * x}, {}, 0};
    way.change = m_inverse * way.arm;
    way.mass = m_inverseMass + way.arm.dot(way.change);
    return way;
}

/// Its depth is in the bias of its row.
void VehicleRows::addSupport(const Support& s, const SupportState& state, double friction, double h) {
    const double stiff = h * m_shape->stiffness + m_shape->damping, soft = 1 / (h * stiff),
                 share = h * m_shape->stiffness / stiff;
    Normal& n = m_normals[m_count];
    const double depth = n.bias;
    const Vec3 centre = m_axes * s.centre, arm = centre - Vec3(0, 0, s.radius);
    n.ax = arm.x();
    n.ay = arm.y();
    n.change = m_inverse * Vec3(arm.y(), -arm.x(), 0);
    n.inverse = 1 / (m_inverseMass + arm.y() * n.change.x() - arm.x() * n.change.y() + soft);
    n.bias = (depth > 0 ? std::min(share * depth, kCorrectingSpeed * h) : depth) / h;
    n.soft = soft;
    n.impulse = state.normal;
    m_v[VZ] += n.impulse * m_inverseMass;
    for (int k = 0; k < 3; ++k) m_v[static_cast<std::size_t>(WX + k)] += n.impulse * n.change[k];
    Friction& f = m_frictions[m_count++];
    f.limit = friction;
    if (!(friction > 0)) return;
    // The way in the axes of the heading, along the ground.
    Vec3 way = m_axes * Vec3(s.way.x(), s.way.y(), 0);
    const double length = std::sqrt(way.x() * way.x() + way.y() * way.y());
    way /= length;
    f.along = wayOf(arm, way.x(), way.y());
    f.across = wayOf(arm, -way.y(), way.x());
    f.coupling = f.along.arm.dot(f.across.change);
    f.lever = s.lever;
    f.wheel = s.wheel;
    f.round = s.round;
    f.alongImpulse = state.along;
    f.acrossImpulse = s.round ? state.across : 0;
    apply(f.along, f.alongImpulse);
    apply(f.across, f.acrossImpulse);
    if (f.lever != 0) m_momenta[f.wheel] -= f.lever * f.alongImpulse;
}

double VehicleRows::speed(const Way& way) const {
    return way.x * m_v[VX] + way.y * m_v[VY] + way.arm.x() * m_v[WX] + way.arm.y() * m_v[WY] + way.arm.z() * m_v[WZ];
}

void VehicleRows::apply(const Way& way, double impulse) {
    m_v[VX] += impulse * m_inverseMass * way.x;
    m_v[VY] += impulse * m_inverseMass * way.y;
    m_v[WX] += impulse * way.change.x();
    m_v[WY] += impulse * way.change.y();
    m_v[WZ] += impulse * way.change.z();
}

double VehicleRows::solveNormal(Normal& row) {
    const double rises = m_v[VZ] + row.ay * m_v[WX] - row.ax * m_v[WY];
    const double change = std::max((row.bias - row.soft * row.impulse - rises) * row.inverse, -row.impulse);
    row.impulse += change;
    m_v[VZ] += change * m_inverseMass;
    m_v[WX] += change * row.change.x();
    m_v[WY] += change * row.change.y();
    m_v[WZ] += change * row.change.z();
    return std::abs(change);
}

/// The change of the impulse along after which the tread does not slip, with the motor's answer; `mass`: inverse, of both.
double VehicleRows::solveAlong(const Friction& row, double speed, double& mass) const {
    mass = row.along.mass;
    if (row.lever == 0) return -speed / mass;
    const MotorLaw& motor = m_motors[row.wheel];
    const double momentum = m_momenta[row.wheel];
    MotorLaw::Piece piece = motor.at(momentum);
    double change = 0;
    for (int again = 0; again < 3; ++again) {
        mass = row.along.mass + row.lever * row.lever * piece.mobility;
        change = (row.lever * piece.spin(momentum) - speed) / mass;
        const MotorLaw::Piece next = motor.at(momentum - row.lever * change);
        if (next.offset == piece.offset && next.mobility == piece.mobility) break;
        piece = next;
    }
    return change;
}

double VehicleRows::solveFriction(Friction& row, double load) {
    const double limit = row.limit * load;
    double mass = 0, along = solveAlong(row, speed(row.along), mass), across = 0;
    if (row.round) {
        const double slip = speed(row.across);
        across = (-slip - row.coupling * along) / row.across.mass;
        const double x = row.alongImpulse + along, y = row.acrossImpulse + across;
        if (x * x + y * y > limit * limit) {
            double to = 0, toAcross = 0;
            ontoCone(to, toAcross, mass, row.across.mass, mass * x, row.across.mass * row.acrossImpulse - slip, limit);
            along = to - row.alongImpulse;
            across = toAcross - row.acrossImpulse;
        }
        row.acrossImpulse += across;
        apply(row.across, across);
    } else along = std::clamp(row.alongImpulse + along, -limit, limit) - row.alongImpulse;
    row.alongImpulse += along;
    apply(row.along, along);
    if (row.lever != 0) m_momenta[row.wheel] -= row.lever * along;
    return std::max(std::abs(along), std::abs(across));
}

double VehicleRows::sweep(bool backwards) {
    double change = 0;
    for (std::size_t q = 0; q < m_count; ++q) change = std::max(change, solveNormal(m_normals[backwards ? m_count - 1 - q : q]));
    for (std::size_t q = 0; q < m_count; ++q) {
        const std::size_t i = backwards ? m_count - 1 - q : q;
        if (m_frictions[i].limit > 0) change = std::max(change, solveFriction(m_frictions[i], m_normals[i].impulse));
    }
    return change;
}

void VehicleRows::finish(WheeledObjects& objects) const {
    WheeledUnit& unit = objects.units[m_unit];
    unit.linear = {m_c * m_v[VX] - m_s * m_v[VY], m_s * m_v[VX] + m_c * m_v[VY], m_v[VZ]};
    unit.angular = {m_c * m_v[WX] - m_s * m_v[WY], m_s * m_v[WX] + m_c * m_v[WY], m_v[WZ]};
    for (std::size_t i = 0; i < m_count; ++i)
        objects.supports[unit.supports + i] = {m_normals[i].impulse, m_frictions[i].limit > 0 ? m_frictions[i].alongImpulse : 0,
                                               m_frictions[i].limit > 0 ? m_frictions[i].acrossImpulse : 0};
    for (std::size_t i = 0; i < m_wheelCount; ++i) {
        WheelState& wheel = objects.wheels[unit.wheels + i];
        wheel.spin = m_motors[i].spin(m_momenta[i]);
        wheel.impulse = m_motors[i].motorImpulse(m_momenta[i]);
        wheel.friction = m_motors[i].impulse(m_momenta[i]) - wheel.impulse - m_h * wheel.motor.viscousFriction * wheel.spin;
        wheel.angle += m_h * wheel.spin;
    }
}

VehicleRows::Push VehicleRows::pushAt(const Vec3& arm, const Vec2& way) const {
    const Vec3 at(m_c * arm.x() + m_s * arm.y(), m_c * arm.y() - m_s * arm.x(), arm.z());
    const Way w = wayOf(at, m_c * way.x() + m_s * way.y(), m_c * way.y() - m_s * way.x());
    return {{w.x, w.y, w.arm.x(), w.arm.y(), w.arm.z()},
            {m_inverseMass * w.x, m_inverseMass * w.y, w.change.x(), w.change.y(), w.change.z()}};
}

} // namespace trundle
