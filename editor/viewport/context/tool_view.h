#pragma once
// What a 3D view offers its tools and painters. They know no more of it, so that they can be read and changed alone.

#include <optional>

#include <QColor>
#include <QPointF>

#include "editor/viewport/context/camera_control.h"
#include "editor/viewport/context/rendered_image.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/view_hints.h"
#include "editor/viewport/context/view_tool.h"

class QWidget;

namespace trundle {

/// What is as near as this in the picture is snapped to.
inline constexpr double kSnapPixels = 14;

class ToolView {
public:
    virtual ~ToolView() = default;

    [[nodiscard]] virtual const ViewContext& context() const = 0;
    [[nodiscard]] virtual QWidget& widget() = 0;
    [[nodiscard]] virtual const QWidget& widget() const = 0;
    [[nodiscard]] virtual CameraControl& camera() = 0;
    [[nodiscard]] virtual const CameraControl& camera() const = 0;
    [[nodiscard]] virtual ViewHints& hints() = 0;
    [[nodiscard]] virtual const ViewHints& hints() const = 0;

    /// The image that is displayed; it can be one image behind the camera and the poses.
    [[nodiscard]] virtual const RenderedImage& rendered() const = 0;
    [[nodiscard]] std::optional<QPointF> shownPixelOf(const Vec3& point) const;
    [[nodiscard]] const BodyPoses& shownPoses() const;
    [[nodiscard]] CameraView shownCamera() const;
    /// At a point in W, along a direction; infinite where it is not seen.
    [[nodiscard]] double metresPerPixel(const Vec3& at, const Vec3& along) const;

    /// Marks the image as outdated. Calls are combined into one request; a hidden view requests none.
    virtual void redraw() = 0;
    virtual void requestMenu(const QPointF& at) = 0; ///< as a right click does

    /// Outline of the selection; the same over every image and in both themes.
    [[nodiscard]] static QColor outlineColour() { return {255, 150, 30}; }

    [[nodiscard]] virtual bool isCurrent() const = 0;                ///< keys and menus apply to it; it shows the legends
    [[nodiscard]] virtual const QPointF& cursorPosition() const = 0; ///< last position of the mouse
    [[nodiscard]] virtual bool isMouseBusy() const = 0;              ///< a tool is active
    /// Ends the active tool although the button is still pressed.
    virtual void endTool(const Pointer& pointer = {}) = 0;
};

} // namespace trundle
