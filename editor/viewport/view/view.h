#pragma once
// One 3D view: an image with overlays and tools. Its parts do the work: the camera, the image, the tools, drops and hints.

#include <QWidget>

#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/view/view_drop.h"
#include "editor/viewport/view/view_image.h"
#include "editor/viewport/view/view_tools.h"

namespace trundle {

class View final : public QWidget, public ToolView {
    Q_OBJECT
public:
    View(const ViewContext& context, ViewKind kind, QWidget* parent = nullptr);
    ~View() override;

    [[nodiscard]] const ViewContext& context() const override { return m_context; }
    [[nodiscard]] QWidget& widget() override { return *this; }
    [[nodiscard]] const QWidget& widget() const override { return *this; }
    [[nodiscard]] CameraControl& camera() override { return m_camera; }
    [[nodiscard]] const CameraControl& camera() const override { return m_camera; }
    [[nodiscard]] ViewHints& hints() override { return m_hints; }
    [[nodiscard]] const ViewHints& hints() const override { return m_hints; }
    [[nodiscard]] const RenderedImage& rendered() const override { return m_image.rendered(); }
    [[nodiscard]] const ViewImage& image() const { return m_image; }
    [[nodiscard]] ViewTools& tools() { return m_tools; }

    /// Frames a box without changing the viewing direction. `gently`: with a short animation, if the view shows an image.
    void frame(const Bounds& bounds, bool gently = true);

    void redraw() override { m_image.redraw(); }
    void requestMenu(const QPointF& at) override { Q_EMIT menuRequested(at); }
    /// Marks the view that keys and menus apply to. `framed`: draw a frame around it, if there are several views. It also shows
    /// the legends.
    void setCurrent(bool current, bool framed);
    [[nodiscard]] bool isCurrent() const override { return m_isCurrent; }

    [[nodiscard]] const QPointF& cursorPosition() const override { return m_cursor; }
    [[nodiscard]] bool isMouseBusy() const override { return m_tools.isActive(); }
    void endTool(const Pointer& pointer = {}) override;

Q_SIGNALS:
    void activated();                      ///< pressed or focused
    void menuRequested(const QPointF& at); ///< right click

protected:
    void paintEvent(QPaintEvent*) override;
    void resizeEvent(QResizeEvent*) override;
    void showEvent(QShowEvent*) override;
    void mousePressEvent(QMouseEvent*) override;
    void mouseMoveEvent(QMouseEvent*) override;
    void mouseReleaseEvent(QMouseEvent*) override;
    void mouseDoubleClickEvent(QMouseEvent*) override;
    void wheelEvent(QWheelEvent*) override;
    void keyPressEvent(QKeyEvent*) override;
    void keyReleaseEvent(QKeyEvent*) override;
    void focusInEvent(QFocusEvent*) override;
    void focusOutEvent(QFocusEvent*) override;
    void leaveEvent(QEvent*) override;
    bool event(QEvent*) override;
    void dragEnterEvent(QDragEnterEvent*) override;
    void dragMoveEvent(QDragMoveEvent*) override;
    void dragLeaveEvent(QDragLeaveEvent*) override;
    void dropEvent(QDropEvent*) override;

private:
    void connectContext(); ///< to what the view shows

    ViewContext m_context;
    CameraControl m_camera;
    ViewHints m_hints;
    ViewImage m_image;
    ViewDrop m_drop; // after what it redraws when it ends
    ViewTools m_tools;
    QPointF m_cursor;
    bool m_hasMouse = false; // m_cursor is where the mouse is
    bool m_isCurrent = false, m_isFramed = false;
};

} // namespace trundle
