#pragma once
// The handles by which objects are moved, turned and sized: where they are on the screen, how they look, which one a point hits.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <QColor>
#include <QPolygonF>
#include <QString>

#include "editor/viewport/view_settings.h"
#include "scene/view.h"

class QPainter;

namespace trundle {

/// Axis, Plane (named by the axis that stands on it), Screen, Ring, Size.
struct Handle {
    enum class Kind { None, Axis, Plane, Screen, Ring, Size };
    Kind kind = Kind::None;
    int axis = 0; ///< 0 x, 1 y, 2 z
    int side = 1; ///< of Size: where the axis points, or -1: the other one
    bool operator==(const Handle&) const = default;
    explicit operator bool() const { return kind != Kind::None; }
};

/// Which sides of a thing go when a length of it grows.
enum class Sides {
    Both,   ///< either, and the other stays: the Pos follows
    Middle, ///< both at once, as with a radius
    Upper,  ///< where the axis points: the thing has its Pos at the other side
    Lower,
};

/// A length of a shape as its text has it: "Radius", "Size x".
struct SizeName {
    QString name;
    double ofHalf = 2; ///< how much larger it is than half the extent
    Sides sides = Sides::Both;
    /// From side to side, so that one side may stay where it is; not a radius, and no height above a base.
    [[nodiscard]] bool hasTwoSides() const { return sides == Sides::Both; }
};

/// Where a gizmo stands.
struct GizmoPlace {
    Vec3 origin = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< columns, unit, right-handed
    Vec3 half = Vec3::Zero();      ///< half the extent of what is sized; 0: cannot be sized along that axis
    std::array<SizeName, 3> sizes; ///< along each axis that can be sized
    double metresPerPixel = 0.01;  ///< at the origin
    Vec3 forward = Vec3::UnitY();  ///< of the camera, at the origin
};

using Projector = std::function<std::optional<QPointF>(const Vec3&)>;

class Gizmo {
public:
    /// Handles that stand so that they could not be dragged with any sense are left out.
    Gizmo(Tool tool, const GizmoPlace& place, const Projector& project);

    [[nodiscard]] Handle hit(const QPointF& at) const;
    /// `hot` is drawn bright, and alone while it is dragged.
    void paint(QPainter& painter, const Handle& hot, bool dragged) const;
    /// Middle of a handle on the screen, for hints and tests.
    [[nodiscard]] std::optional<QPointF> spot(const Handle& handle) const;

private:
    struct Shape {
        Handle handle;
        QColor colour;
        std::vector<QPolygonF> lines, faint; ///< faint: behind
        QPolygonF face;                      ///< filled
        QPointF spot;
    };
    void addArrow(int axis);
    void addPlane(int axis);
    void addScreen();
    void addRing(int axis);
    void addSize(int axis, int side);

    GizmoPlace m_place;
    Projector m_project;
    std::vector<Shape> m_shapes; // drawn in this order, hit in the other
};

} // namespace trundle
