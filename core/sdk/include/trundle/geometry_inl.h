// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <cmath>
#include <numbers>

namespace trundle {

namespace detail {
/// sin and cos of angle/2: exact at multiples of a half turn, at quarter turns as exact as sqrt(1/2).
inline void halfSinCos(double angle, double& s, double& c) {
    const double quarters = angle * 2 / std::numbers::pi;
    const double whole = std::nearbyint(quarters);
    if (std::abs(quarters - whole) < 1e-13 && std::abs(whole) < 1e6) {
        const double r = std::sqrt(0.5);
        static const double sines[8] = {0, r, 1, r, 0, -r, -1, -r};
        const int k = ((static_cast<int>(whole) % 8) + 8) % 8;
        s = sines[k];
        c = sines[(k + 2) % 8];
        return;
    }
    s = std::sin(angle / 2);
    c = std::cos(angle / 2);
}
} // namespace detail

inline Quat rotationFromHpr(const Vec3& hpr) {
    double sh, ch, sp, cp, sr, cr;
    detail::halfSinCos(hpr.x(), sh, ch);
    detail::halfSinCos(hpr.y(), sp, cp);
    detail::halfSinCos(hpr.z(), sr, cr);
    return Quat(ch, 0, 0, sh) * Quat(cp, 0, sp, 0) * Quat(cr, sr, 0, 0);
}

inline Vec3 hprFromRotation(const Quat& q) {
    const Mat3 r = q.toRotationMatrix();
    const double sinPitch = -r(2, 0);
    if (std::abs(sinPitch) > 1 - 1e-12) { // gimbal lock: heading and roll share one axis; heading gets the whole angle
        return {std::atan2(-r(0, 1), r(1, 1)), std::copysign(std::numbers::pi / 2, sinPitch), 0};
    }
    return {std::atan2(r(1, 0), r(0, 0)), std::asin(sinPitch), std::atan2(r(2, 1), r(2, 2))};
}

} // namespace trundle
