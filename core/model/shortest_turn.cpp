#include "model/shortest_turn.h"

namespace trundle {

namespace {

/// For unit vectors at most a right angle apart.
Quat smallTurn(const Vec3& a, const Vec3& b) {
    const Vec3 middle = (a + b).normalized(), axis = a.cross(middle);
    return Quat(a.dot(middle), axis.x(), axis.y(), axis.z()).normalized();
}

} // namespace

Quat shortestTurn(const Vec3& from, const Vec3& to) {
    const Vec3 a = from.normalized(), b = to.normalized();
    if (a.dot(b) >= 0) return smallTurn(a, b);
    // Onto -b, then half a turn: the axis between nearly opposite directions is known badly, but it need only be across b.
    Vec3 axis = a.cross(b);
    if (axis.norm() > 0) axis.normalize();
    axis -= axis.dot(b) * b;
    axis = axis.squaredNorm() > 0.25 ? axis.normalized() : b.unitOrthogonal();
    return (Quat(0, axis.x(), axis.y(), axis.z()) * smallTurn(a, -b)).normalized();
}

} // namespace trundle
