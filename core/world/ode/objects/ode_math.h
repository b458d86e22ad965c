#pragma once
// Conversions between ODE's arrays and Eigen vectors.

#include <ode/ode.h>

#include <trundle/geometry.h>

namespace trundle {

inline Vec3 vec(const dReal* v) { return {v[0], v[1], v[2]}; }
/// R v and R^T v with ODE's row-major 3x4 rotation matrix.
inline Vec3 turn(const dReal* r, const Vec3& v) {
    return {r[0] * v.x() + r[1] * v.y() + r[2] * v.z(), r[4] * v.x() + r[5] * v.y() + r[6] * v.z(),
            r[8] * v.x() + r[9] * v.y() + r[10] * v.z()};
}
inline Vec3 turnBack(const dReal* r, const Vec3& v) {
    return {r[0] * v.x() + r[4] * v.y() + r[8] * v.z(), r[1] * v.x() + r[5] * v.y() + r[9] * v.z(),
            r[2] * v.x() + r[6] * v.y() + r[10] * v.z()};
}
inline Mat3 matrix(const dReal* r) {
    Mat3 m;
    m << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
    return m;
}
/// Times u: v x u.
inline Mat3 crossing(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}
/// ODE's quaternion order: w x y z.
inline Quat quat(const dReal* q) { return {q[0], q[1], q[2], q[3]}; }
inline void toOde(const Quat& q, dReal out[4]) {
    out[0] = q.w();
    out[1] = q.x();
    out[2] = q.y();
    out[3] = q.z();
}

} // namespace trundle
