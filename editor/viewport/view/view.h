#pragma once
// One 3D view: requests images from the render service when something changes, and paints them with their overlays.

#include <functional>
#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include "editor/viewport/context/tool_view.h"
#include "scene/queries/object_index.h"
#include "scene/queries/ray_cast.h"

class QMimeData;

namespace trundle {

struct ExperimentSpec;
class GizmoTool;
class LibraryDrop;
class Navigation;
struct PictureRequest;

class View final : public QWidget, public ToolView {
    Q_OBJECT
public:
    View(const ViewContext& context, ViewKind kind, QWidget* parent = nullptr);
    ~View() override;

    [[nodiscard]] const ViewContext& context() const override { return m_context; }
    [[nodiscard]] QWidget& widget() override { return *this; }
    [[nodiscard]] const QWidget& widget() const override { return *this; }
    [[nodiscard]] const ViewCamera& camera() const override { return m_camera; }
    void setKind(ViewKind kind);
    void setCamera(const CameraView& view);
    /// Frames a box without changing the viewing direction. `gently`: with a short animation.
    void frame(const Bounds& bounds, bool gently = true);
    void changeCamera(const std::function<void(ViewCamera&)>& change) override;
    /// Looks through a robot's camera, "robot0/eye", and follows it until the user moves the view. "": returns to the previous
    /// view.
    void lookThrough(const std::string& camera);
    /// Shows a View block of the experiment and follows it until the user moves the view.
    void showNamed(const std::string& name);
    [[nodiscard]] const std::string& named() const { return m_named; } ///< empty: none
    /// The experiment whose View blocks can be chosen: the current text, also while an older world runs.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> textOfViews() const;
    /// A View block for the current camera: "View view { Eye=... }".
    [[nodiscard]] std::string viewBlockText() const;
    [[nodiscard]] const CameraModel* throughCamera() const override;
    /// The image request for another image size, without marks; the image contains everything that the view shows.
    [[nodiscard]] PictureRequest still(std::uint32_t width, std::uint32_t height) const;
    /// The camera of such an image for other body poses; must be called in order of time.
    [[nodiscard]] std::function<CameraView(const BodyPoses&)> movingView(std::uint32_t width, std::uint32_t height) const;

    [[nodiscard]] CameraView cameraView() const override;
    [[nodiscard]] ViewRay rayAt(const QPointF& at) const override;
    [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3& point) const override;
    [[nodiscard]] Vec3 pointUnder(const QPointF& at) const override;
    [[nodiscard]] std::optional<QPointF> shownPixelOf(const Vec3& point) const override;
    [[nodiscard]] const BodyPoses& shownPoses() const override;
    [[nodiscard]] CameraView shownCamera() const override { return m_image.image.isNull() ? cameraView() : m_image.camera; }

    void redraw() override;
    void setHovered(const std::string& path, const QString& hint) override;
    void setHint(const QString& hint) override;
    void requestMenu(const QPointF& at) override { Q_EMIT menuRequested(at); }
    [[nodiscard]] const QString& hint() const { return m_hint; }
    /// Marks the view that keys and menus apply to. `framed`: draw a frame around it, if there are several views. It also shows
    /// the legends.
    void setCurrent(bool current, bool framed);
    [[nodiscard]] bool isCurrent() const override { return m_isCurrent; }

    /// Number of images requested because of a change, and number of refinements requested when idle. For tests.
    [[nodiscard]] int redraws() const { return m_redraws; }
    [[nodiscard]] int refinements() const { return m_refinements; }
    /// A view that displays an error instead of an image also counts as up to date.
    [[nodiscard]] bool isUpToDate() const { return !m_wanted && !m_inFlight && !(m_image.image.isNull() && m_failure.isEmpty()); }
    [[nodiscard]] bool isSettled() const { return isUpToDate() && !m_settle.isActive() && !m_glide.isActive(); }
    [[nodiscard]] const QImage& picture() const { return m_image.image; }
    [[nodiscard]] const QPointF& cursorPosition() const override { return m_cursor; }
    [[nodiscard]] bool isMouseBusy() const override { return m_activeTool != nullptr; }
    void endTool(const Pointer& pointer = {}) override;
    [[nodiscard]] GizmoTool& gizmo() { return *m_gizmo; }

Q_SIGNALS:
    void kindChanged();
    void activated();                                       ///< pressed or focused
    void menuRequested(const QPointF& at);                  ///< right click
    void dropped(const QMimeData& data, const QPointF& at); ///< from the Library
    void pictureShown();

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
    struct Inbox;
    /// An image with the camera and poses it was drawn for.
    struct RenderedImage {
        QImage image;
        CameraView camera;
        std::shared_ptr<const ObjectIndex> objects;
        std::shared_ptr<const BodyPoses> poses;
    };
    void pump();
    void ask(bool fine);
    void take(int number, const QImage& image, const QString& failure, RenderedImage frame, bool software);
    /// A refinement in progress is cancelled by a new request.
    [[nodiscard]] bool mayAsk() const { return m_wanted && (!m_inFlight || m_fine) && isVisible(); }
    [[nodiscard]] PictureRequest request(bool fine) const;
    void followSelection();
    [[nodiscard]] std::optional<ObjectRef> followedRobot() const;
    void followCamera();
    void followNamed();
    bool leaveCamera();
    [[nodiscard]] CameraView throughView(const CameraModel& camera, const BodyPoses& poses) const;
    void paintThrough(QPainter& painter) const;
    void makeTools();
    void connectContext(); ///< to what the view shows
    void settle();
    void glide();
    void cancelTool();
    [[nodiscard]] Pointer pointerOf(const QMouseEvent& event) const;
    void paintMessage(QPainter& painter, const QString& text) const;
    void paintHints(QPainter& painter) const;
    bool acceptsDrop(QDropEvent& event) const;

    ViewContext m_context;
    ViewCamera m_camera, m_glideFrom, m_glideTo, m_beforeThrough;
    std::string m_through; // path of the camera that the view looks through
    std::string m_named;   // name of the View block that the view shows
    std::shared_ptr<Inbox> m_inbox;
    std::vector<std::unique_ptr<ViewTool>> m_tools;
    ViewTool* m_activeTool = nullptr; // receives the mouse events
    Qt::MouseButton m_workButton = Qt::NoButton;
    Navigation* m_navigation = nullptr;
    GizmoTool* m_gizmo = nullptr;
    RenderedImage m_image;
    QString m_failure, m_hint, m_hoverHint;
    std::string m_hovered;
    std::unique_ptr<LibraryDrop> m_drop; // non-null during a drag from the Library over this view
    QPointF m_cursor, m_dropAt{-1, -1};
    QTimer m_pumpTimer, m_settle, m_glide;
    QElapsedTimer m_sinceAsked, m_gliding;
    bool m_wanted = true, m_inFlight = false, m_fine = false, m_software = true, m_dropping = false, m_dropMoves = false,
         m_isCurrent = false, m_isFramed = false;
    int m_redraws = 0, m_refinements = 0; // their sum is the number of the last request
};

} // namespace trundle
