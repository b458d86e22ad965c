// CameraControl: a robot, a robot's camera or a View block that the view follows, and images in other aspect ratios.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <QWidget>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/viewport/context/camera_control.h"
#include "editor/viewport/context/viewport_scene.h"
#include "lang/number_text.h"
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

CameraView throughView(const CameraModel& camera, const BodyPoses& poses, double aspect) {
    const CameraView view = viewOf(camera, camera.body < poses.size() ? poses[camera.body] : Pose{});
    return reshaped(view, double(camera.width) / std::max(1u, camera.height), aspect);
}

} // namespace

/// nullopt unless the view follows a robot.
std::optional<ObjectRef> CameraControl::followedRobot() const {
    if (m_camera.kind() != ViewKind::Follow && m_camera.kind() != ViewKind::Chase) return std::nullopt;
    const ViewportScene& world = m_context.world;
    const std::optional<ObjectRef> selected = world.find(m_context.selection.current());
    if (selected && world.objects()->robotOf(*selected)) return ObjectRef{ObjectKind::Robot, selected->instance};
    if (world.objects()->experiment().robots.empty()) return std::nullopt;
    return ObjectRef{ObjectKind::Robot, 0};
}

void CameraControl::follow() {
    followCamera();
    followNamed();
    if (const auto robot = followedRobot()) m_camera.follow(m_context.world.poseOf(*robot));
}

/// The free camera is kept at the same pose, so that orbiting continues from there.
void CameraControl::followCamera() {
    if (m_through.empty()) return;
    const CameraModel* camera = through();
    if (!camera) {
        m_through.clear();
        m_camera = m_beforeThrough;
        Q_EMIT kindChanged();
        return;
    }
    CameraView view = throughView(*camera, *m_context.world.poses(), aspect());
    view.target = view.eye + kAhead * (view.target - view.eye);
    m_camera.setView(view);
}

void CameraControl::followNamed() {
    if (m_named.empty()) return;
    if (const auto view = namedNow()) return m_camera.setView(*view);
    const auto& loaded = m_context.document.loaded();
    if (loaded && loaded->diagnostics.hasErrors()) return; // while a text is typed: the View is there again when it is whole
    m_named.clear();
    Q_EMIT kindChanged();
}

std::optional<CameraView> CameraControl::namedNow() const {
    return namedView(*textOfViews(), m_named, m_context.world.objects()->experiment(), *m_context.world.poses());
}

const CameraModel* CameraControl::through() const { return m_through.empty() ? nullptr : m_context.world.camera(m_through); }

void CameraControl::lookThrough(const std::string& camera) {
    if (camera == m_through) return;
    if (!camera.empty() && !m_context.world.camera(camera)) return;
    m_glide.stop();
    m_named.clear(); // it is not that View's any more
    if (m_through.empty()) m_beforeThrough = m_camera;
    if (camera.empty()) m_camera = m_beforeThrough;
    m_through = camera;
    followCamera();
    Q_EMIT kindChanged();
    Q_EMIT changed();
}

bool CameraControl::leaveCamera() {
    const bool was = !m_through.empty() || !m_named.empty();
    m_through.clear();
    m_named.clear();
    return was;
}

void CameraControl::showNamed(const std::string& name) {
    m_glide.stop();
    leaveCamera();
    m_camera.setKind(ViewKind::Perspective);
    m_named = name;
    followNamed();
    Q_EMIT kindChanged();
    Q_EMIT changed();
}

std::shared_ptr<const ExperimentSpec> CameraControl::textOfViews() const {
    if (m_context.document.isOpen()) return m_context.document.loaded()->experiment;
    const auto objects = m_context.world.objects();
    return {objects, &objects->experiment()};
}

std::string CameraControl::viewBlockText() const {
    CameraView view = this->view();
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

CameraView CameraControl::view() const {
    if (const CameraModel* camera = through()) return throughView(*camera, *m_context.world.poses(), aspect());
    if (!m_named.empty())
        if (const auto view = namedNow()) return *view;
    if (!m_camera.isParallel()) return m_camera.view();
    const Bounds all = m_context.world.bounds();
    return m_camera.view(all.empty() ? 0 : (all.centre() - m_camera.middle()).norm() + all.radius());
}

CameraView CameraControl::viewFor(std::uint32_t width, std::uint32_t height) const {
    return reshaped(view(), aspect(), double(width) / height);
}

std::function<CameraView(const BodyPoses&)> CameraControl::movingView(std::uint32_t width, std::uint32_t height) const {
    const double from = aspect(), to = double(width) / height;
    if (const CameraModel* camera = through())
        return [camera = *camera, to](const BodyPoses& poses) { return throughView(camera, poses, to); };
    if (!m_named.empty())
        return [objects = m_context.world.objects(), text = textOfViews(), name = m_named, now = view(), from,
                to](const BodyPoses& poses) {
            return reshaped(namedView(*text, name, objects->experiment(), poses).value_or(now), from, to);
        };
    const auto robot = followedRobot();
    if (!robot) return [view = reshaped(view(), from, to)](const BodyPoses&) { return view; };
    return [camera = m_camera, objects = m_context.world.objects(), robot = *robot, from, to](const BodyPoses& poses) mutable {
        if (poses.size() == objects->poseCount()) camera.follow(objects->poseOf(robot, poses));
        return reshaped(camera.view(), from, to);
    };
}

} // namespace trundle
