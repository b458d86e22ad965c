// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Points, rotations and poses. Metres, radians; right-handed, z up; in a robot's frame +x is forward, +y left.

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace trundle {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
/// Written as w x y z in all texts and signals, whatever Eigen's storage order.
using Quat = Eigen::Quaternion<double, Eigen::DontAlign>;

struct Pose {
    Vec3 position = Vec3::Zero();
    Quat rotation = Quat::Identity();

    [[nodiscard]] Vec3 operator*(const Vec3& point) const { return position + rotation * point; }
    [[nodiscard]] Pose operator*(const Pose& inner) const {
        return {position + rotation * inner.position, (rotation * inner.rotation).normalized()};
    }
    [[nodiscard]] Pose inverse() const {
        const Quat r = rotation.conjugate();
        return {-(r * position), r};
    }
};

/// R = Rz(heading) Ry(pitch) Rx(roll), in radians. Exact at multiples of a quarter turn.
[[nodiscard]] Quat rotationFromHpr(const Vec3& hpr);
/// Heading and roll in (-pi, pi], pitch in [-pi/2, pi/2].
[[nodiscard]] Vec3 hprFromRotation(const Quat& rotation);

} // namespace trundle
#include <trundle/geometry_inl.h>
