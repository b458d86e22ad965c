#include "world/wheeled/wheeled_motion.h"

#include <cmath>

namespace trundle {

void moveOn(WheeledUnit& unit, double h) {
    unit.position += h * unit.linear;
    const Vec3& w = unit.angular;
    const double square = h * h * w.squaredNorm();
    if (square > 0) {
        const Quat& q = unit.rotation;
        const double scale = h / 2 * (1 + square / 12); // tan(x/2) = x/2 (1 + x^2/12 ...)
        const Vec3 v = scale * w;
        Quat next(q.w() - v.x() * q.x() - v.y() * q.y() - v.z() * q.z(), q.x() + v.x() * q.w() + v.y() * q.z() - v.z() * q.y(),
                  q.y() + v.y() * q.w() + v.z() * q.x() - v.x() * q.z(), q.z() + v.z() * q.w() + v.x() * q.y() - v.y() * q.x());
        const double norm = std::sqrt(next.w() * next.w() + next.x() * next.x() + next.y() * next.y() + next.z() * next.z());
        unit.rotation = Quat(next.w() / norm, next.x() / norm, next.y() / norm, next.z() / norm);
    }
    unit.setPlane();
}

void publishStates(WheeledObjects& objects, std::uint32_t index) {
    const WheeledUnit& unit = objects.units[index];
    const ActorShape& shape = *unit.shape;
    const Mat3 axes = unit.rotation.toRotationMatrix();
    for (std::uint32_t i = 0; i < shape.bodies.size(); ++i) {
        BodyState& state = objects.states[unit.bodies + i];
        const Vec3 arm = axes * shape.bodies[i].position;
        state.position = unit.position + arm;
        state.rotation = unit.rotation;
        if (shape.isTurned[i]) state.rotation = unit.rotation * shape.bodies[i].rotation;
        state.linear = unit.linear + unit.angular.cross(arm);
        state.angular = unit.angular;
    }
    for (std::uint32_t k = 0; k < shape.wheels.size(); ++k) {
        const WheelShape& wheel = shape.wheels[k];
        const WheelState& now = objects.wheels[unit.wheels + k];
        BodyState& state = objects.states[unit.bodies + wheel.body];
        const Vec3 axis = axes * wheel.axis, along = now.halfSine * wheel.axis;
        const Quat turn(now.halfCosine, along.x(), along.y(), along.z());
        state.rotation = unit.rotation * turn;
        if (shape.isTurned[wheel.body]) state.rotation = state.rotation * shape.bodies[wheel.body].rotation;
        state.angular += now.spin * axis;
        if (wheel.offset.isZero(0)) continue;
        const Vec3 offset = turn * wheel.offset, arm = axes * (shape.bodies[wheel.body].position - wheel.offset + offset);
        state.position = unit.position + arm;
        state.linear = unit.linear + unit.angular.cross(arm) + now.spin * (axes * wheel.axis.cross(offset));
    }
}

} // namespace trundle
