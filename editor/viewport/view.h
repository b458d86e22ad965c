#pragma once
// One 3D view: asks the render service for pictures when something changed, and paints them with what belongs over them.

#include <functional>
#include <memory>
#include <vector>

#include <QElapsedTimer>
#include <QImage>
#include <QTimer>
#include <QWidget>

#include "editor/viewport/mouse_work.h"
#include "editor/viewport/view_camera.h"
#include "scene/object_index.h"
#include "scene/ray_cast.h"

class QMimeData;

namespace trundle {

class Document;
struct ExperimentSpec;
class GizmoWork;
class LibraryDrop;
class Measurement;
class Navigation;
class PinnedValues;
class RadioOverlays;
class RenderService;
class RunSession;
class Selection;
class ShownWorld;
class Trails;
class ViewSettings;
struct CameraModel;
struct PictureRequest;

/// What the views of a panel share. `render` may be null.
struct ViewParts {
    Document& document;
    Selection& selection;
    RunSession& session;
    ShownWorld& world;
    ViewSettings& settings;
    Measurement& measurement;
    RenderService* render = nullptr;
    Trails* trails = nullptr;
    RadioOverlays* radios = nullptr;
    PinnedValues* pinned = nullptr;
};

class View final : public QWidget {
    Q_OBJECT
public:
    View(const ViewParts& parts, ViewKind kind, QWidget* parent = nullptr);
    ~View() override;

    [[nodiscard]] const ViewParts& parts() const { return m_parts; }
    [[nodiscard]] const ViewCamera& camera() const { return m_camera; }
    void setKind(ViewKind kind);
    void setCamera(const CameraView& view);
    /// Shows a box from where the camera looks. `gently`: on the way there pictures in between are shown, for a moment.
    void frame(const Bounds& bounds, bool gently = true);
    void changeCamera(const std::function<void(ViewCamera&)>& change);
    /// Looks through a robot's camera, "robot0/eye", and goes with it until the view is moved by itself. "": back to where it was.
    void lookThrough(const std::string& camera);
    /// Looks as a View of the experiment does, and goes with it until the view is moved by itself.
    void showNamed(const std::string& name);
    [[nodiscard]] const std::string& named() const { return m_named; } ///< empty: none
    /// The experiment whose Views can be chosen: as its text is now, also while an older one runs.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> textOfViews() const;
    /// The text of a View that looks as this one does now: "View view { Eye=... }".
    [[nodiscard]] std::string asViewBlock() const;
    [[nodiscard]] const CameraModel* throughCamera() const; ///< null where it looks through none
    /// What is drawn in a picture of another size, without marks: all that the view shows is in it.
    [[nodiscard]] PictureRequest still(std::uint32_t width, std::uint32_t height) const;
    /// Where such a picture is taken from while bodies stand elsewhere; called with one moment after the other.
    [[nodiscard]] std::function<CameraView(const BodyPoses&)> movingView(std::uint32_t width, std::uint32_t height) const;

    [[nodiscard]] CameraView cameraView() const;
    [[nodiscard]] ViewRay rayAt(const QPointF& at) const;
    [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3& point) const;
    /// What lies under a pixel: the nearest thing, else the ground at z = 0, else a point at the distance looked at.
    [[nodiscard]] Vec3 pointUnder(const QPointF& at) const;
    /// As the picture that is shown has it, which can be one behind.
    [[nodiscard]] std::optional<QPointF> shownPixelOf(const Vec3& point) const;
    [[nodiscard]] const BodyPoses& shownPoses() const;
    [[nodiscard]] CameraView shownCamera() const { return m_frame.image.isNull() ? cameraView() : m_frame.camera; }

    /// The picture is out of date. Many calls make one request; none is made while the view is hidden.
    void redraw();
    /// What is outlined thinly, and said beside the cursor; empty: nothing.
    void setHovered(const std::string& path, const QString& hint);
    /// A line of words at the lower edge, while something is done; empty: none.
    void setHint(const QString& hint);
    [[nodiscard]] const QString& hint() const { return m_hint; }
    /// The one that keys and menus mean, framed where there are several. Legends stand in it.
    void setCurrent(bool current, bool framed);
    [[nodiscard]] bool isCurrent() const { return m_isCurrent; }

    /// Pictures asked for because something changed, and those asked for once more, finer, when all stood still.
    [[nodiscard]] int redraws() const { return m_redraws; }
    [[nodiscard]] int refinements() const { return m_refinements; }
    /// A view that says why there is no picture has nothing to wait for either.
    [[nodiscard]] bool isUpToDate() const { return !m_wanted && !m_inFlight && !(m_frame.image.isNull() && m_failure.isEmpty()); }
    [[nodiscard]] bool isSettled() const { return isUpToDate() && !m_settle.isActive() && !m_glide.isActive(); }
    [[nodiscard]] const QImage& picture() const { return m_frame.image; }
    [[nodiscard]] const QPointF& cursorAt() const { return m_cursor; } ///< where the mouse was last
    [[nodiscard]] bool mouseIsBusy() const { return m_working != nullptr; }
    /// The work that has the mouse is done, although the button is still down.
    void endWork(const Pointer& pointer = {});
    /// Of what is selected: the same over every picture and in both themes.
    [[nodiscard]] static QColor outlineColour();
    [[nodiscard]] GizmoWork& gizmo() { return *m_gizmo; }

Q_SIGNALS:
    void kindChanged();
    void activated();                                       ///< it was pressed or got the focus
    void menuWanted(const QPointF& at);                     ///< right click
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
    /// A picture with all that tells where things are in it.
    struct Frame {
        QImage image;
        CameraView camera;
        std::shared_ptr<const ObjectIndex> objects;
        std::shared_ptr<const BodyPoses> poses;
    };
    void pump();
    void ask(bool fine);
    void take(int number, const QImage& image, const QString& failure, Frame frame, bool software);
    /// A finer picture gives way to one of something new.
    [[nodiscard]] bool mayAsk() const { return m_wanted && (!m_inFlight || m_fine) && isVisible(); }
    [[nodiscard]] PictureRequest request(bool fine) const;
    void followSelection();
    [[nodiscard]] std::optional<ObjectRef> followedRobot() const;
    void followCamera();
    void followNamed();
    bool leaveCamera();
    [[nodiscard]] CameraView throughView(const CameraModel& camera, const BodyPoses& poses) const;
    void paintThrough(QPainter& painter) const;
    void settle();
    void glide();
    void cancelWork();
    [[nodiscard]] Pointer pointerOf(const QMouseEvent& event) const;
    void paintMessage(QPainter& painter, const QString& text) const;
    void paintHints(QPainter& painter) const;
    bool takesDrop(QDropEvent& event) const;

    ViewParts m_parts;
    ViewCamera m_camera, m_glideFrom, m_glideTo, m_beforeThrough;
    std::string m_through; // camera that it looks through
    std::string m_named;   // View of the experiment that it looks as
    std::shared_ptr<Inbox> m_inbox;
    std::vector<std::unique_ptr<MouseWork>> m_works;
    MouseWork* m_working = nullptr; // has the mouse
    Qt::MouseButton m_workButton = Qt::NoButton;
    Navigation* m_navigation = nullptr;
    GizmoWork* m_gizmo = nullptr;
    Frame m_frame;
    QString m_failure, m_hint, m_hoverHint;
    std::string m_hovered;
    std::unique_ptr<LibraryDrop> m_drop; // a drag from the Library is over this view
    QPointF m_cursor, m_dropAt{-1, -1};
    QTimer m_pumpTimer, m_settle, m_glide;
    QElapsedTimer m_sinceAsked, m_gliding;
    bool m_wanted = true, m_inFlight = false, m_fine = false, m_software = true, m_dropping = false, m_dropMoves = false,
         m_isCurrent = false, m_isFramed = false;
    int m_redraws = 0, m_refinements = 0; // together: the number of the picture asked for last
};

} // namespace trundle
