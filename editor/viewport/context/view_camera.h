#pragma once
// Camera of a view, and its motion by mouse and keys. Angles in rad, lengths in m.

#include "scene/queries/camera_view.h"
#include "scene/shapes/bounds.h"

namespace trundle {

enum class ViewKind { Perspective, Orthographic, Top, Front, Side, Follow, Chase };

/// Always upright: heading and pitch, no roll.
class ViewCamera {
public:
    [[nodiscard]] ViewKind kind() const { return m_kind; }
    [[nodiscard]] bool isParallel() const { return m_parallel; }
    /// Axis views rotate the camera and use parallel projection; Follow and Chase use perspective. The centre of the view is
    /// kept, and how much is seen there; the field of view is the usual one afterwards.
    void setKind(ViewKind kind);

    /// The view for an image of this shape. `reach`: extent of the scene around the centre, so that a parallel view does not clip
    /// it.
    [[nodiscard]] CameraView view(double reach = 0) const;
    void setView(const CameraView& view); ///< with its field of view, which motions keep

    /// Orbits about a point, whose position in the image is kept. An axis view becomes a perspective view.
    void orbit(double heading, double pitch, const Vec3& about);
    /// Rotates about the eye.
    void rotate(double heading, double pitch);
    /// Moves the image so that the point `from` appears where `to` was.
    void pan(const Vec3& from, const Vec3& to) { m_eye += from - to; }
    /// Scales the view about a point, whose position in the image is kept; factor 0.5 shows everything twice as large.
    void zoom(double factor, const Vec3& about);
    /// Moves the eye; `way` is along the camera's right, up and forward axes (m).
    void fly(const Vec3& way);
    /// Frames a box without changing the viewing direction.
    void frame(const Bounds& bounds, double width, double height);
    /// Follow and Chase: moves with a robot. The first pose after setKind() is the reference.
    void follow(const Pose& robot);

    [[nodiscard]] Vec3 forward() const;
    [[nodiscard]] Vec3 middle() const { return m_eye + m_distance * forward(); }
    [[nodiscard]] double distance() const { return m_distance; } ///< from the eye to the centre of the view
    [[nodiscard]] double metresPerPixel(double width, const Vec3& at) const;

private:
    [[nodiscard]] Vec3 upward() const;
    [[nodiscard]] Vec3 right() const { return forward().cross(upward()); }

    ViewKind m_kind = ViewKind::Perspective;
    bool m_parallel = false, m_following = false;
    Vec3 m_eye{2, -4, 2.5}, m_lastRobot = Vec3::Zero();
    double m_heading = 2, m_pitch = -0.5, m_distance = 5, m_lastHeading = 0;
    double m_halfWidth = std::numbers::sqrt2 - 1; // tangent of half the field of view
};

} // namespace trundle
