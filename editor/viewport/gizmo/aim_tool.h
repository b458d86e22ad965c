#pragma once
#include <optional>
#include <string>

#include <QObject>

#include "base/result.h"
#include "editor/viewport/context/view_tool.h"
#include "project/objects/part_values.h"

namespace trundle {

class ToolView;

/// Turns the selected sensor, camera or antenna about its position, by the end of the line along which it looks or sends, or by its frustum,
/// beams or lobe; a handle beside the line rolls it about that. Writes HPR. A drag is one undo entry; Esc cancels it.
class AimTool final : public QObject, public ViewTool {
    Q_OBJECT
public:
    explicit AimTool(ToolView& view);

    bool press(const Pointer& pointer) override;
    void drag(const Pointer& pointer) override;
    void release(const Pointer& pointer) override;
    void cancel() override;
    bool hover(const Pointer& pointer) override;
    void leave() override;
    void paint(QPainter& painter) override;

    /// Screen position of a handle, if it is visible.
    [[nodiscard]] std::optional<QPointF> spot();
    [[nodiscard]] std::optional<QPointF> rollSpot();

private:
    /// The selected device: where it is and where it looks.
    struct Aimed {
        std::string path, text;     ///< text: HPR as written where it is edited
        std::string shape;          ///< path of the device itself; of all members of a Repeat, the first one's
        Pose X_WB, X_BD;            ///< of its body, of the device in it
        Quat described;             ///< HPR of the text
        Vec3 hpr;                   ///< rad, the same as it is written
        Vec3 sight = Vec3::UnitX(); ///< unit vector in the frame of the device
        DescribedFrame mirror;      ///< signs of the Part that it is in
        [[nodiscard]] Vec3 position() const { return X_WB * X_BD.position; }
        [[nodiscard]] Vec3 direction() const { return X_WB.rotation * (X_BD.rotation * sight); }
    };
    [[nodiscard]] std::optional<Aimed> selected() const;
    [[nodiscard]] const Aimed* aimed();
    /// What the mouse has hold of.
    struct Grip {
        enum class Kind { None, Sight, Shape, Roll };
        Kind kind = Kind::None;
        Vec3 point = Vec3::Zero(); ///< in W
    };
    [[nodiscard]] Vec3 end(const Aimed& aimed) const;
    [[nodiscard]] std::optional<Vec3> rollEnd(const Aimed& aimed) const; ///< of a device that looks along its x
    [[nodiscard]] Grip gripAt(const QPointF& at);
    [[nodiscard]] Quat aimedRotation(const Pointer& pointer, bool snaps) const; ///< in the body
    [[nodiscard]] Quat rolledRotation(const Pointer& pointer, bool snaps) const;
    Status turnTo(const Quat& rotation, double fine);
    [[nodiscard]] QString label(const Aimed& aimed) const;

    ToolView& m_view;
    std::optional<Aimed> m_aimed, m_start; ///< m_start: during a drag, as before it
    bool m_known = false, m_wrote = false;
    Grip::Kind m_hot = Grip::Kind::None;
    Grip m_grip;                    ///< during a drag
    Vec3 m_gripped = Vec3::UnitX(); ///< the direction to what was gripped, as the mouse points at it; unit vector in W
    double m_length = 0.1;          ///< m, from the device to what was gripped
    std::string m_mergeKey;
};

} // namespace trundle
