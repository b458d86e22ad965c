#include "world/ode/motion/free_rotation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

namespace trundle {

namespace {

constexpr double kRound = 1e-12;    // relative difference of moments
constexpr double kSubstep = 0.2;    // rad that the lesser terms may turn the body at once
constexpr double kLittle = 0.02;    // relative change of a rate in half a tick
constexpr double kSubstepsMax = 64; // beyond: less exact, still with the right momentum

// Three steps of second order that make one of fourth: Yoshida 1990.
constexpr double kOuter = 1.3512071919596576;
constexpr std::array kFourthOrder{kOuter, 1 - 2 * kOuter, kOuter};

Quat about(const Vec3& axis, double angle) {
    const double s = std::sin(angle / 2);
    return {std::cos(angle / 2), s * axis.x(), s * axis.y(), s * axis.z()};
}

Mat3 cross(const Vec3& v) {
    Mat3 m;
    m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
    return m;
}

/// Turns the body about one of its axes, by what of its momentum lies along it.
void turnAbout(int axis, double angle, Quat& turned, Vec3& momentum) {
    const Quat step = about(Vec3::Unit(axis), angle);
    turned = turned * step;
    momentum = step.conjugate() * momentum;
}

} // namespace

RotationalInertia::RotationalInertia(const Mat3& inertia) : m_tensor(inertia), m_inverse(inertia.inverse()) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(inertia); // ascending
    const Vec3 moments = solver.eigenvalues();
    m_round = moments[2] - moments[0] <= kRound * moments[2];
    // The first two axes are those most alike.
    const bool lowPair = 1 / moments[0] - 1 / moments[1] < 1 / moments[1] - 1 / moments[2];
    const std::array order = lowPair ? std::array{1, 0, 2} : std::array{1, 2, 0};
    Mat3 axes;
    for (int i = 0; i < 3; ++i) axes.col(i) = solver.eigenvectors().col(order[static_cast<std::size_t>(i)]);
    if (axes.determinant() < 0) axes.col(2) *= -1;
    m_axes = Quat(axes).normalized();
    m_ball = 1 / moments[order[0]];
    m_second = 1 / moments[order[1]] - m_ball;
    m_third = 1 / moments[order[2]] - m_ball;
    if (std::abs(m_second) <= kRound * m_ball) m_second = 0;
}

Vec3 RotationalInertia::rate(const Quat& rotation, const Vec3& momentum) const {
    return rotation * (m_inverse * (rotation.conjugate() * momentum));
}

Vec3 RotationalInertia::momentum(const Quat& rotation, const Vec3& rate) const {
    return rotation * (m_tensor * (rotation.conjugate() * rate));
}

Quat RotationalInertia::turnedFreely(const Quat& rotation, const Vec3& momentum, double h) const {
    const double size = momentum.norm();
    if (!(size > 0)) return rotation;
    Vec3 own = m_axes.conjugate() * (rotation.conjugate() * momentum); // in principal axes
    Quat turned = Quat::Identity();
    if (m_second == 0) {
        turnAbout(2, h * m_third * own.z(), turned, own);
    } else {
        const double most = h * size * std::max(std::abs(m_second), std::abs(m_third));
        const double steps = std::clamp(std::ceil(most / kSubstep), 1.0, kSubstepsMax);
        for (int i = 0; i < static_cast<int>(steps); ++i)
            for (const double share : kFourthOrder) {
                const double t = share * h / steps;
                turnAbout(2, t / 2 * m_third * own.z(), turned, own);
                turnAbout(1, t * m_second * own.y(), turned, own);
                turnAbout(2, t / 2 * m_third * own.z(), turned, own);
            }
    }
    return (about(momentum / size, h * size * m_ball) * rotation * m_axes * turned * m_axes.conjugate()).normalized();
}

/// I (w1 - w0) + h m x I m = 0 with m = (w0 + w1) / 2: explicitly where little changes, else by two steps of Newton's method.
Vec3 RotationalInertia::changeByMidpoint(const Vec3& rate, double h) const {
    const Vec3 half = rate - h / 2 * (m_inverse * rate.cross(m_tensor * rate));
    const Vec3 change = -h * half.cross(m_tensor * half);
    if ((half - rate).squaredNorm() <= kLittle * kLittle * rate.squaredNorm()) return change;
    Vec3 after = rate;
    for (int i = 0; i < 2; ++i) {
        const Vec3 mean = (rate + after) / 2, momentum = m_tensor * mean;
        const Vec3 error = m_tensor * (after - rate) + h * mean.cross(momentum);
        const Mat3 slope = m_tensor + h / 2 * (cross(mean) * m_tensor - cross(momentum));
        after -= slope.inverse() * error;
    }
    return after.allFinite() ? Vec3(m_tensor * (after - rate)) : Vec3::Zero();
}

Quat turnedBy(const Vec3& rotation) {
    const double angle = rotation.norm();
    if (!(angle > 0)) return Quat::Identity();
    return about(rotation / angle, angle);
}

Vec3 meanRate(const Quat& from, const Quat& to, double h, const Vec3& expected) {
    Quat turned = to * from.conjugate();
    if (turned.w() < 0) turned.coeffs() = -turned.coeffs();
    const double s = turned.vec().norm(), angle = 2 * std::atan2(s, turned.w()), size = expected.norm();
    if (s < 1e-12 && !(size > 0)) return 2 / h * turned.vec();
    const Vec3 axis = s < 1e-12 ? Vec3(expected / size) : Vec3(turned.vec() / s);
    const double whole = std::nearbyint((h * expected.dot(axis) - angle) / (2 * std::numbers::pi));
    if (s < 1e-12 && whole == 0) return 2 / h * turned.vec();
    return (angle + 2 * std::numbers::pi * whole) / h * axis;
}

} // namespace trundle
