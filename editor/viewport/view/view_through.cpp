// Views through a robot's camera or a View block, and images of a view in other aspect ratios.

#include <cmath>
#include <numbers>

#include <QPainter>
#include <QPainterPath>

#include "editor/document/document.h"
#include "editor/viewport/context/label.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/view/view.h"
#include "lang/number_text.h"
#include "render/service.h"
#include "scene/queries/camera_model.h"
#include "scene/queries/framing.h"

namespace trundle {
namespace {

constexpr double kAhead = 2; // m, view distance used for a robot's camera

/// Adapts a view to another aspect ratio without losing anything: the image shows more at the sides, or above and below.
CameraView reshaped(CameraView view, double from, double to) {
    if (to <= from) return view;
    view.fieldOfView = 2 * std::atan(std::tan(0.5 * view.fieldOfView) * to / from);
    view.orthographicWidth *= to / from;
    return view;
}

double aspectOf(const CameraModel& camera) { return double(camera.width) / std::max(1u, camera.height); }

} // namespace

const CameraModel* View::throughCamera() const { return m_through.empty() ? nullptr : m_context.world.camera(m_through); }

CameraView View::throughView(const CameraModel& camera, const BodyPoses& poses) const {
    const CameraView view = viewOf(camera, camera.body < poses.size() ? poses[camera.body] : Pose{});
    return reshaped(view, aspectOf(camera), double(std::max(1, width())) / std::max(1, height()));
}

void View::lookThrough(const std::string& camera) {
    if (camera == m_through) return;
    if (!camera.empty() && !m_context.world.camera(camera)) return;
    m_glide.stop();
    if (m_through.empty()) m_beforeThrough = m_camera;
    if (camera.empty()) m_camera = m_beforeThrough;
    m_through = camera;
    followCamera();
    Q_EMIT kindChanged();
    redraw();
}

/// The free camera is kept at the same pose, so that orbiting continues from there.
void View::followCamera() {
    if (m_through.empty()) return;
    const CameraModel* camera = throughCamera();
    if (!camera) {
        m_through.clear();
        m_camera = m_beforeThrough;
        Q_EMIT kindChanged();
        return;
    }
    CameraView view = throughView(*camera, *m_context.world.poses());
    view.target = view.eye + kAhead * (view.target - view.eye);
    m_camera.setView(view);
}

bool View::leaveCamera() {
    const bool was = !m_through.empty() || !m_named.empty();
    m_through.clear();
    m_named.clear();
    return was;
}

void View::showNamed(const std::string& name) {
    m_glide.stop();
    leaveCamera();
    m_camera.setKind(ViewKind::Perspective);
    m_named = name;
    followNamed();
    Q_EMIT kindChanged();
    redraw();
}

std::shared_ptr<const ExperimentSpec> View::textOfViews() const {
    if (m_context.document.isOpen()) return m_context.document.loaded()->experiment;
    const auto objects = m_context.world.objects();
    return {objects, &objects->experiment()};
}

void View::followNamed() {
    if (m_named.empty()) return;
    const auto view = namedView(*textOfViews(), m_named, m_context.world.objects()->experiment(), *m_context.world.poses());
    if (view) return m_camera.setView(*view);
    m_named.clear();
    Q_EMIT kindChanged();
}

std::string View::viewBlockText() const {
    CameraView view = cameraView();
    if (view.orthographicWidth > 0) { // a View block has perspective: uses the distance that shows the same width
        const Vec3 back = (view.eye - view.target).normalized();
        view.target = m_camera.middle();
        view.eye = view.target + 0.5 * view.orthographicWidth / std::tan(0.5 * view.fieldOfView) * back;
    }
    const auto triple = [](const Vec3& v) {
        return steppedNumber(v.x(), 0.001) + "," + steppedNumber(v.y(), 0.001) + "," + steppedNumber(v.z(), 0.001);
    };
    return "View view { Eye=" + triple(view.eye) + " Target=" + triple(view.target) +
           " FieldOfView=" + steppedNumber(view.fieldOfView * 180 / std::numbers::pi, 0.1) + " }\n";
}

PictureRequest View::still(std::uint32_t width, std::uint32_t height) const {
    PictureRequest r = request(true);
    r.view = reshaped(*r.view, double(std::max(1, this->width())) / std::max(1, this->height()), double(width) / height);
    r.width = width;
    r.height = height;
    r.marks = {};
    r.yields = false;
    return r;
}

std::function<CameraView(const BodyPoses&)> View::movingView(std::uint32_t width, std::uint32_t height) const {
    const double from = double(std::max(1, this->width())) / std::max(1, this->height()), to = double(width) / height;
    if (const CameraModel* camera = throughCamera())
        return [camera = *camera, to](const BodyPoses& poses) {
            return reshaped(viewOf(camera, camera.body < poses.size() ? poses[camera.body] : Pose{}), aspectOf(camera), to);
        };
    if (!m_named.empty())
        return [objects = m_context.world.objects(), text = textOfViews(), name = m_named, now = cameraView(), from,
                to](const BodyPoses& poses) {
            return reshaped(namedView(*text, name, objects->experiment(), poses).value_or(now), from, to);
        };
    const auto robot = followedRobot();
    if (!robot) return [view = reshaped(cameraView(), from, to)](const BodyPoses&) { return view; };
    return [camera = m_camera, objects = m_context.world.objects(), robot = *robot, from, to](const BodyPoses& poses) mutable {
        if (poses.size() == objects->poseCount()) camera.follow(objects->poseOf(robot, poses));
        return reshaped(camera.view(), from, to);
    };
}

/// Dims the area outside the camera's own image.
void View::paintThrough(QPainter& painter) const {
    const CameraModel* camera = throughCamera();
    if (!camera) return;
    const double aspect = aspectOf(*camera), high = std::min(double(height()), width() / aspect), wide = high * aspect;
    const QRectF frame(0.5 * (width() - wide), 0.5 * (height() - high), wide, high);
    QPainterPath rim;
    rim.addRect(rect());
    rim.addRect(frame);
    painter.fillPath(rim, QColor(16, 18, 22, 120));
    painter.setPen(QPen(QColor(245, 246, 248, 190), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(frame.adjusted(0.5, 0.5, -0.5, -0.5));
    const bool bends = camera->k1 != 0 || camera->k2 != 0;
    const QString words = (bends ? tr("Through %1, without its Distortion  •  Esc leaves") : tr("Through %1  •  Esc leaves"))
                              .arg(QString::fromStdString(m_through));
    paintLabel(painter, {0.5 * width(), 8 + 0.5 * (painter.fontMetrics().height() + 6)}, words);
}

} // namespace trundle
