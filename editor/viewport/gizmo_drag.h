#pragma once
// What a drag of a handle comes to: how far along its axes, by which angle.

#include <string>

#include "editor/viewport/gizmo.h"

namespace trundle {

class GizmoDrag {
public:
    GizmoDrag(const Handle& handle, const GizmoPlace& place, const ViewRay& start, const QPointF& pixel);

    /// The mouse is there now. Steps in m and degrees; 0: no steps. A length from side to side grows by the side that is dragged,
    /// `aboutCentre` by both.
    void to(const ViewRay& ray, const QPointF& pixel, double moveStep, double turnStep, bool aboutCentre = false);
    /// Keys typed while dragging: numbers, with their unit or without, commas between them, Backspace. True where they were used.
    bool type(int key, const QString& text);
    [[nodiscard]] const std::string& typed() const { return m_typed; }

    [[nodiscard]] const Handle& handle() const { return m_handle; }
    /// m along the axes of the gizmo (Axis, Plane, Screen), or by which half the extent grows (Size).
    [[nodiscard]] Vec3 amount() const;
    [[nodiscard]] double degrees() const; ///< of a Ring
    /// Size: the other side stays where it is, and the middle goes out by amount().
    [[nodiscard]] bool isOneSided() const;
    /// Of the world: what stood at p stands at motion * p. Of Size, where the middle of the sized object goes.
    [[nodiscard]] Pose motion() const;
    /// "X 0.35 m", "45°", "Radius 0.1 m".
    [[nodiscard]] QString readOut() const;

private:
    [[nodiscard]] Vec3 pointOf(const ViewRay& ray) const;
    [[nodiscard]] double angleOf(const Vec3& point) const;
    [[nodiscard]] std::optional<Vec3> typedNumbers() const;

    Handle m_handle;
    GizmoPlace m_place;
    Vec3 m_start, m_amount = Vec3::Zero();
    QPointF m_startPixel;
    double m_lastAngle = 0, m_turned = 0, m_degrees = 0; // rad, rad, degrees
    bool m_edgeOn = false, m_aboutCentre = false;
    std::string m_typed;
};

} // namespace trundle
