#pragma once
// The gizmo for moving, rotating and scaling objects: its handles on the screen, their appearance and hit test.

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <QColor>
#include <QPolygonF>
#include <QString>

#include "editor/viewport/context/view_settings.h"
#include "scene/queries/camera_view.h"

class QPainter;

namespace trundle {

/// A handle: Axis, Plane (`axis` is its normal), Screen, Ring or Size.
struct GizmoHandle {
    enum class Kind { None, Axis, Plane, Screen, Ring, Size };
    Kind kind = Kind::None;
    int axis = 0;        ///< 0 x, 1 y, 2 z
    int side = 1;        ///< for Size: 1 on the positive side of the axis, -1 on the negative side
    bool layout = false; ///< for Size: of the extent of a whole Grid or Scatter
    bool operator==(const GizmoHandle&) const = default;
    explicit operator bool() const { return kind != Kind::None; }
};

/// Which sides of an object move when a size grows.
enum class Sides {
    Both,   ///< either one; the other stays, and Pos is adjusted
    Middle, ///< both at once, as with a radius
    Upper,  ///< the positive one; Pos is at the negative side
    Lower,
};

/// A size of a shape, with its name in the text: "Radius", "Size x".
struct SizeName {
    QString name;
    double ofHalf = 2; ///< factor from half the extent to the value
    Sides sides = Sides::Both;
    /// True for a size measured from side to side, so that one side can stay in place; not for a radius or a height above a base.
    [[nodiscard]] bool hasTwoSides() const { return sides == Sides::Both; }
};

/// Pose and sizes of a gizmo, in world coordinates.
struct GizmoPose {
    Vec3 origin = Vec3::Zero();
    Mat3 axes = Mat3::Identity();  ///< columns, unit, right-handed
    Vec3 half = Vec3::Zero();      ///< m, half the extent of the scaled object; 0: cannot be scaled along that axis
    std::array<SizeName, 3> sizes; ///< one per axis that can be scaled
    bool layout = false;           ///< the sizes are those of a whole Grid or Scatter
    double margin = 0;             ///< m, added to `half` for the position of the handles
    double metresPerPixel = 0.01;  ///< at the origin
    Vec3 forward = Vec3::UnitY();  ///< the camera's viewing direction, at the origin
};

using Projector = std::function<std::optional<QPointF>(const Vec3&)>;

class Gizmo {
public:
    /// Handles that cannot be dragged sensibly from this view are left out.
    Gizmo(Tool tool, const GizmoPose& place, const Projector& project);

    [[nodiscard]] GizmoHandle hit(const QPointF& at) const;
    /// `hot` is drawn highlighted, and alone while it is dragged.
    void paint(QPainter& painter, const GizmoHandle& hot, bool dragged) const;
    /// Centre of a handle on the screen, for hints and tests.
    [[nodiscard]] std::optional<QPointF> spot(const GizmoHandle& handle) const;

private:
    struct Shape {
        GizmoHandle handle;
        QColor colour;
        std::vector<QPolygonF> lines, faint; ///< faint: on the far side
        QPolygonF face;                      ///< filled
        QPointF spot;
    };
    void addArrow(int axis);
    void addPlane(int axis);
    void addScreen();
    void addRing(int axis);
    void addSize(int axis, int side);

    GizmoPose m_place;
    Projector m_project;
    std::vector<Shape> m_shapes; // in drawing order; hit-tested in reverse
};

} // namespace trundle
