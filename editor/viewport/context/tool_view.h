#pragma once
// What a 3D view offers its tools and painters. They know no more of it, so that they can be read and changed alone.

#include <functional>
#include <optional>

#include <QColor>
#include <QPointF>

#include "editor/viewport/context/view_camera.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/view_tool.h"
#include "scene/queries/poses.h"
#include "scene/queries/ray_cast.h"

class QWidget;

namespace trundle {

struct CameraModel;

class ToolView {
public:
    virtual ~ToolView() = default;

    [[nodiscard]] virtual const ViewContext& context() const = 0;
    [[nodiscard]] virtual QWidget& widget() = 0;
    [[nodiscard]] virtual const QWidget& widget() const = 0;

    [[nodiscard]] virtual const ViewCamera& camera() const = 0;
    virtual void changeCamera(const std::function<void(ViewCamera&)>& change) = 0;
    [[nodiscard]] virtual const CameraModel* throughCamera() const = 0; ///< null unless the view looks through a camera
    [[nodiscard]] virtual CameraView cameraView() const = 0;
    [[nodiscard]] virtual ViewRay rayAt(const QPointF& at) const = 0;
    [[nodiscard]] virtual std::optional<QPointF> pixelOf(const Vec3& point) const = 0;
    /// The point under a pixel: on the nearest object, otherwise on the ground at z = 0, otherwise at the view distance.
    [[nodiscard]] virtual Vec3 pointUnder(const QPointF& at) const = 0;

    // The image that is displayed can be one image behind.
    [[nodiscard]] virtual std::optional<QPointF> shownPixelOf(const Vec3& point) const = 0;
    [[nodiscard]] virtual const BodyPoses& shownPoses() const = 0;
    [[nodiscard]] virtual CameraView shownCamera() const = 0;

    /// Marks the image as outdated. Calls are combined into one request; a hidden view requests none.
    virtual void redraw() = 0;
    /// Sets the hovered object, outlined thinly, and the hint beside the cursor; empty: none.
    virtual void setHovered(const std::string& path, const QString& hint) = 0;
    /// Sets the hint at the lower edge; empty: none.
    virtual void setHint(const QString& hint) = 0;
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
