#pragma once
// Converts a mouse drag of a gizmo handle to a translation, rotation or size change.

#include <optional>
#include <string>

#include "editor/viewport/gizmo/gizmo.h"
#include "schema/kind.h"

namespace trundle {

class GizmoDrag {
public:
    GizmoDrag(const GizmoHandle& handle, const GizmoPose& place, const ViewRay& start, const QPointF& pixel);

    /// Updates the drag to the mouse position. Steps in m and degrees; 0: no snapping. A side-to-side size grows at the dragged
    /// side only, or at both with `aboutCentre`.
    void to(const ViewRay& ray, const QPointF& pixel, double moveStep, double rotationStep, bool aboutCentre = false);
    /// Numbers typed during the drag, with or without units, one for each axis, separated by commas; Backspace deletes. True if the
    /// key was used.
    bool type(int key, const QString& text);
    [[nodiscard]] const std::string& typed() const { return m_typed; }
    /// Why what is typed is no value of the handle, so that the mouse counts; empty if it is one or nothing is typed.
    [[nodiscard]] const QString& fault() const { return m_fault; }

    /// Replaces the steps of the last to() along the axes that are dragged.
    void snapTo(const Vec3& amount) { m_amount = amount; }
    [[nodiscard]] const Vec3& unsnapped() const { return m_unsnapped; } ///< amount() without steps

    [[nodiscard]] const GizmoHandle& handle() const { return m_handle; }
    /// Whether it moves along that axis of the gizmo.
    [[nodiscard]] bool isAlong(int axis) const;
    /// m along the axes of the gizmo (Axis, Plane, Screen), or the change of half the extent (Size).
    [[nodiscard]] Vec3 amount() const;
    [[nodiscard]] double degrees() const; ///< rotation angle of a Ring
    /// Size: the opposite side stays in place and the centre moves by amount().
    [[nodiscard]] bool isOneSided() const;
    /// Motion in world coordinates: a point p moves to motion() * p. For Size, the motion of the object's centre.
    [[nodiscard]] Pose motion() const;
    /// Readout of the drag: "X 0.35 m", "45°", "Radius 0.1 m".
    [[nodiscard]] QString readOut() const;

private:
    [[nodiscard]] Vec3 pointOf(const ViewRay& ray) const;
    [[nodiscard]] double angleOf(const Vec3& point) const;
    [[nodiscard]] int axisCount() const; ///< how many numbers can be typed
    [[nodiscard]] Property typedProperty() const;
    void read(); ///< sets m_numbers and m_fault

    GizmoHandle m_handle;
    GizmoPose m_place;
    Vec3 m_start, m_amount = Vec3::Zero(), m_unsnapped = Vec3::Zero();
    QPointF m_startPixel;
    double m_lastAngle = 0, m_turned = 0, m_degrees = 0; // rad, rad, degrees
    bool m_edgeOn = false, m_aboutCentre = false;
    std::string m_typed;
    std::optional<Vec3> m_numbers; ///< that are typed, for the axes in their order
    QString m_fault;
};

} // namespace trundle
