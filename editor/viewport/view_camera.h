#pragma once
// Where a view looks from, and how mouse and keys move it. Angles in rad, lengths in m.

#include "scene/bounds.h"
#include "scene/view.h"

namespace trundle {

enum class ViewKind { Perspective, Orthographic, Top, Front, Side, Follow, Chase };

/// Stands upright always: heading and pitch, never a roll.
class ViewCamera {
public:
    [[nodiscard]] ViewKind kind() const { return m_kind; }
    [[nodiscard]] bool isParallel() const { return m_parallel; }
    /// Axis views turn the camera and make it parallel; Follow and Chase are perspective. What is in the middle stays there.
    void setKind(ViewKind kind);

    /// For a picture of this shape. `reach`: how far the scene extends about the middle, so that a parallel view cuts nothing off.
    [[nodiscard]] CameraView view(double reach = 0) const;
    void setView(const CameraView& view);

    /// Turns about a point, which stays where it is in the picture. An axis view becomes a free one.
    void orbit(double heading, double pitch, const Vec3& about);
    /// Turns about the eye.
    void look(double heading, double pitch);
    /// What was at `from` is then seen where `to` was.
    void pan(const Vec3& from, const Vec3& to) { m_eye += from - to; }
    /// Everything twice as large for factor 0.5; the point stays where it is in the picture.
    void zoom(double factor, const Vec3& about);
    /// Right, up and forward, in the camera's own directions.
    void fly(const Vec3& way);
    /// Shows all of it from where the camera looks now.
    void frame(const Bounds& bounds, double width, double height);
    /// For Follow and Chase: goes with a robot. The first pose after setKind() is where it begins.
    void follow(const Pose& robot);

    [[nodiscard]] Vec3 forward() const;
    [[nodiscard]] Vec3 middle() const { return m_eye + m_distance * forward(); }
    [[nodiscard]] double distance() const { return m_distance; } ///< from the eye to what it looks at
    [[nodiscard]] double metresPerPixel(double width, const Vec3& at) const;

private:
    [[nodiscard]] Vec3 upward() const;
    [[nodiscard]] Vec3 right() const { return forward().cross(upward()); }

    ViewKind m_kind = ViewKind::Perspective;
    bool m_parallel = false, m_following = false;
    Vec3 m_eye{2, -4, 2.5}, m_lastRobot = Vec3::Zero();
    double m_heading = 2, m_pitch = -0.5, m_distance = 5, m_lastHeading = 0;
};

} // namespace trundle
