#pragma once
// The handles of a joint on the screen: its anchor, its axes, its stops, the cone of a Ball, the travel of a Suspension.

#include <optional>
#include <vector>

#include <QPointF>
#include <QString>

#include "editor/viewport/gizmo/edited_joint.h"

class QPainter;

namespace trundle {

class ToolView;

struct JointHandle {
    enum class Kind { None, Anchor, Axis, Stop, Swing, Travel };
    Kind kind = Kind::None;
    JointStop stop; ///< of a Stop; of an Axis, `isSecond`; of a Travel, `isHigh`
    bool operator==(const JointHandle&) const = default;
    explicit operator bool() const { return kind != Kind::None; }
};

class JointHandles {
public:
    static constexpr double kCirclePart = 0.66; ///< radius of the circle of the stops and of the cone, as part of the arrow

    /// `asShown`: on the image that is shown; otherwise for the present camera.
    JointHandles(const EditedJoint& joint, const ToolView& view, bool asShown);

    [[nodiscard]] JointHandle hit(const QPointF& at) const;
    [[nodiscard]] std::optional<QPointF> spot(const JointHandle& handle) const;
    /// `hot` is highlighted and labelled.
    void paint(QPainter& painter, const JointHandle& hot) const;

    /// m, of the arrow of an axis and of the circle of its stops.
    [[nodiscard]] double length() const { return m_length; }
    /// What a handle is, and its value: "HighStop 40°".
    [[nodiscard]] QString label(const JointHandle& handle) const;

private:
    struct Spot {
        JointHandle handle;
        QPointF at;
        bool isSet = true; ///< a stop that the joint has
    };
    void add(const JointHandle& handle, const Vec3& p_C, bool isSet = true);
    void addStops(bool second);
    void addLimits();
    [[nodiscard]] Vec3 onCone(double swing, double around) const; ///< in C; rad
    [[nodiscard]] Vec3 onCircle(double angle, bool second) const; ///< in C
    [[nodiscard]] double shownStop(const JointStop& stop) const;
    void paintAxis(QPainter& painter, bool second, bool isHot) const;
    void paintRange(QPainter& painter, bool second) const;
    void paintArc(QPainter& painter, bool second, double low, double high) const;
    void paintCone(QPainter& painter) const;
    void paintTravel(QPainter& painter) const;

    const EditedJoint& m_joint;
    const ToolView& m_view;
    bool m_asShown;
    double m_length = 0.1;
    std::vector<Spot> m_spots;
};

} // namespace trundle
