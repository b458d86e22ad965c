#include "editor/viewport/context/view_camera.h"

#include <algorithm>
#include <cmath>

namespace trundle {
namespace {

constexpr double kHalfWidth = std::numbers::sqrt2 - 1; // tan(22.5°), of the usual field of view, 45°
constexpr double kQuarter = std::numbers::pi / 2;
constexpr double kNearest = 0.02, kFarthest = 5000; // m, limits of the view distance
constexpr double kFarAway = 1e5;                    // m; an eye farther away is moved back
constexpr double kRoom = 0.88;                      // fraction of the image that the framed box fills
constexpr double kBeyond = 4;                       // depth of a parallel view, as a multiple of the reach

Vec3 headingOf(double heading) { return {std::cos(heading), std::sin(heading), 0}; }

Mat3 rotateAbout(const Vec3& axis, double angle) { return Eigen::AngleAxisd(angle, axis).toRotationMatrix(); }

/// Replaces rounding errors around 0 by 0, so that axis views are exactly axis-aligned.
Vec3 clean(Vec3 v) {
    for (int i = 0; i < 3; ++i)
        if (std::abs(v[i]) < 1e-15) v[i] = 0;
    return v;
}

} // namespace

Vec3 ViewCamera::forward() const { return clean(std::cos(m_pitch) * headingOf(m_heading) + std::sin(m_pitch) * Vec3::UnitZ()); }

Vec3 ViewCamera::upward() const { return clean(-std::sin(m_pitch) * headingOf(m_heading) + std::cos(m_pitch) * Vec3::UnitZ()); }

void ViewCamera::setKind(ViewKind kind) {
    const Vec3 at = middle();
    m_distance = std::clamp(m_distance * (m_halfWidth / kHalfWidth), kNearest, kFarthest);
    m_halfWidth = kHalfWidth;
    m_kind = kind;
    m_following = false;
    m_parallel = kind != ViewKind::Perspective && kind != ViewKind::Follow && kind != ViewKind::Chase;
    if (kind == ViewKind::Top) m_heading = kQuarter, m_pitch = -kQuarter;
    if (kind == ViewKind::Front) m_heading = kQuarter, m_pitch = 0;
    if (kind == ViewKind::Side) m_heading = std::numbers::pi, m_pitch = 0;
    m_eye = at - m_distance * forward();
}

CameraView ViewCamera::view(double reach) const {
    CameraView view;
    view.eye = m_eye;
    view.target = middle();
    view.up = upward();
    view.fieldOfView = 2 * std::atan(m_halfWidth);
    if (m_parallel) {
        view.orthographicWidth = 2 * m_distance * m_halfWidth;
        const double back = std::max(m_distance, 1.2 * reach + 1);
        view.eye = view.target - back * forward();
        view.nearPlane = 0.01;
        view.farPlane = back + kBeyond * std::max(reach, m_distance) + 10;
    }
    return view;
}

void ViewCamera::setView(const CameraView& view) {
    const Vec3 along = view.target - view.eye;
    m_eye = view.eye;
    m_distance = std::clamp(along.norm(), kNearest, kFarthest);
    m_pitch = std::asin(std::clamp(along.z() / along.norm(), -1.0, 1.0));
    const Vec3 up = cameraAxes(view).col(1); // straight down or up, it says where the heading is in the picture
    const Vec3 ahead = along.head<2>().norm() > 1e-9 ? along : along.z() < 0 ? up : Vec3(-up);
    m_heading = std::atan2(ahead.y(), ahead.x());
    m_parallel = view.orthographicWidth > 0;
    m_kind = m_parallel ? ViewKind::Orthographic : ViewKind::Perspective;
    m_halfWidth = m_parallel ? kHalfWidth : std::tan(0.5 * view.fieldOfView);
    if (m_parallel) {
        const Vec3 at = view.target;
        m_distance = std::clamp(0.5 * view.orthographicWidth / m_halfWidth, kNearest, kFarthest);
        m_eye = at - m_distance * forward();
    }
}

void ViewCamera::orbit(double heading, double pitch, const Vec3& about) {
    if (m_kind == ViewKind::Top || m_kind == ViewKind::Front || m_kind == ViewKind::Side) m_kind = ViewKind::Orthographic;
    const double turned = std::clamp(m_pitch + pitch, -kQuarter, kQuarter) - m_pitch;
    const Mat3 turn = rotateAbout(Vec3::UnitZ(), heading) * rotateAbout(right(), turned);
    m_eye = about + turn * (m_eye - about);
    m_heading = std::remainder(m_heading + heading, 2 * std::numbers::pi);
    m_pitch += turned;
}

void ViewCamera::rotate(double heading, double pitch) { orbit(heading, pitch, m_eye); }

void ViewCamera::zoom(double factor, const Vec3& about) {
    factor = std::clamp(m_distance * factor, kNearest, kFarthest) / m_distance;
    m_eye = about + factor * (m_eye - about);
    m_distance *= factor;
    if (m_eye.norm() > kFarAway) m_eye *= kFarAway / m_eye.norm();
}

void ViewCamera::fly(const Vec3& way) {
    m_eye += way.x() * right() + way.y() * Vec3::UnitZ() + way.z() * forward();
    if (m_eye.norm() > kFarAway) m_eye *= kFarAway / m_eye.norm();
}

void ViewCamera::frame(const Bounds& bounds, double width, double height) {
    Bounds box = bounds;
    if (box.empty()) box = {Vec3(-1, -1, 0), Vec3(1, 1, 0.5)}; // empty floor: leave room for objects
    if (box.radius() < 0.05) box.grow(0.05);
    Mat3 axes;
    axes << right(), upward(), -forward();
    const double halfWidth = m_halfWidth * kRoom, halfHeight = halfWidth * height / std::max(1.0, width);
    Vec3 at = box.centre();
    double distance = 0;
    for (int round = 0; round < 4; ++round) {
        distance = 0;
        double left = 1e300, high = -1e300, rightmost = -1e300, low = 1e300;
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = axes.transpose() * (box.corner(i) - at);
            const double nearer = m_parallel ? 0 : p.z();
            distance = std::max({distance, nearer + std::abs(p.x()) / halfWidth, nearer + std::abs(p.y()) / halfHeight});
        }
        for (int i = 0; i < 8; ++i) {
            const Vec3 p = axes.transpose() * (box.corner(i) - at);
            const double depth = m_parallel ? 1 : std::max(1e-6, distance - p.z()) / distance;
            left = std::min(left, p.x() / depth), rightmost = std::max(rightmost, p.x() / depth);
            low = std::min(low, p.y() / depth), high = std::max(high, p.y() / depth);
        }
        if (round < 3) at += 0.5 * (left + rightmost) * axes.col(0) + 0.5 * (low + high) * axes.col(1);
    }
    m_distance = std::clamp(distance, kNearest, kFarthest);
    m_eye = at - m_distance * forward();
}

void ViewCamera::follow(const Pose& robot) {
    if (m_kind != ViewKind::Follow && m_kind != ViewKind::Chase) return;
    const double heading = hprFromRotation(robot.rotation).x();
    if (!m_following) {
        // Chase views from behind and above; Follow keeps the camera's offset.
        if (m_kind == ViewKind::Chase) {
            m_heading = heading;
            m_pitch = -0.38;
            m_distance = std::clamp(m_distance, 0.8, 4.0);
        }
        m_eye = robot.position - m_distance * forward();
    } else {
        m_eye += robot.position - m_lastRobot;
        if (m_kind == ViewKind::Chase) orbit(std::remainder(heading - m_lastHeading, 2 * std::numbers::pi), 0, robot.position);
    }
    m_following = true;
    m_lastRobot = robot.position;
    m_lastHeading = heading;
}

double ViewCamera::metresPerPixel(double width, const Vec3& at) const {
    const double depth = m_parallel ? m_distance : std::max(1e-6, forward().dot(at - m_eye));
    return 2 * depth * m_halfWidth / std::max(1.0, width);
}

} // namespace trundle
