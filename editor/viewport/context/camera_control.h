#pragma once
// The camera of a 3D view: free, following a robot, that of a robot, or the one of a View block.

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <QElapsedTimer>
#include <QObject>
#include <QPointF>
#include <QTimer>

#include "editor/viewport/context/view_camera.h"
#include "editor/viewport/context/view_context.h"
#include "scene/queries/object_index.h"
#include "scene/queries/ray_cast.h"

class QWidget;

namespace trundle {

struct CameraModel;
struct ExperimentSpec;

class CameraControl final : public QObject {
    Q_OBJECT
public:
    /// The image has the size of `view`. Both must outlive this object.
    CameraControl(const ViewContext& context, const QWidget& view, ViewKind kind);

    /// The camera that the user moves; where the view shows another camera, it is kept at the pose of that one.
    [[nodiscard]] const ViewCamera& free() const { return m_camera; }
    [[nodiscard]] CameraView view() const;
    /// The same for an image of another size: it contains everything that the view shows.
    [[nodiscard]] CameraView viewFor(std::uint32_t width, std::uint32_t height) const;
    /// The camera of such an image for other body poses; must be called in order of time.
    [[nodiscard]] std::function<CameraView(const BodyPoses&)> movingView(std::uint32_t width, std::uint32_t height) const;

    [[nodiscard]] ViewRay rayAt(const QPointF& at) const;
    [[nodiscard]] std::optional<QPointF> pixelOf(const Vec3& point) const;
    /// The point under a pixel: on the nearest object, otherwise on the ground at z = 0, otherwise at the view distance.
    [[nodiscard]] Vec3 pointUnder(const QPointF& at) const;

    void setKind(ViewKind kind);
    void setView(const CameraView& view);
    void change(const std::function<void(ViewCamera&)>& change);
    /// Frames a box without changing the viewing direction. `gently`: with a short animation.
    void frame(const Bounds& bounds, bool gently);
    [[nodiscard]] bool isMoving() const { return m_glide.isActive(); } ///< in that animation
    /// The free camera after that animation.
    [[nodiscard]] const ViewCamera& destination() const { return isMoving() ? m_glideTo : m_camera; }
    void stop() { m_glide.stop(); }

    /// Looks through a robot's camera, "robot0/eye", and follows it until the user moves the view. "": returns to the previous
    /// view.
    void lookThrough(const std::string& camera);
    [[nodiscard]] const CameraModel* through() const; ///< null unless the view looks through a camera
    [[nodiscard]] bool isThrough() const { return !m_through.empty(); }
    /// Shows a View block of the experiment and follows it until the user moves the view.
    void showNamed(const std::string& name);
    [[nodiscard]] const std::string& named() const { return m_named; } ///< empty: none
    /// The experiment whose View blocks can be chosen: the current text, also while an older world runs.
    [[nodiscard]] std::shared_ptr<const ExperimentSpec> textOfViews() const;
    /// A View block for the current camera: "View view { Eye=... }".
    [[nodiscard]] std::string viewBlockText() const;

Q_SIGNALS:
    void changed();
    void kindChanged();

private:
    void connectContext();
    void follow(); ///< what the view follows has moved
    void followCamera();
    void followNamed();
    [[nodiscard]] std::optional<CameraView> namedNow() const;
    [[nodiscard]] std::optional<ObjectRef> followedRobot() const;
    bool leaveCamera();
    void glide();
    [[nodiscard]] std::uint32_t width() const;
    [[nodiscard]] std::uint32_t height() const;
    [[nodiscard]] double aspect() const { return double(width()) / height(); }

    const ViewContext& m_context;
    const QWidget& m_view;
    ViewCamera m_camera, m_glideFrom, m_glideTo, m_beforeThrough;
    std::string m_through; // path of the camera that the view looks through
    std::string m_named;   // name of the View block that the view shows
    QTimer m_glide;
    QElapsedTimer m_gliding;
};

} // namespace trundle
