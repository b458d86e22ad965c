#include "editor/viewport/overlays/frusta.h"

#include <set>

#include "editor/document/selection.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/viewport_scene.h"
#include "scene/queries/camera_model.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxFrusta = 200, kMaxUnasked = 4;
const QColor kFrustum(70, 196, 222);

void paintFrustum(const ScenePainter& pen, const CameraModel& camera, const Pose& body, const QColor& colour, double width) {
    const Pose lens = body * camera.mounting;
    const double wide = std::tan(0.5 * camera.fieldOfView), high = wide * camera.height / std::max(1u, camera.width);
    const auto corner = [&](double depth, int i) {
        const double left = i == 0 || i == 3 ? 1 : -1, up = i < 2 ? 1 : -1;
        return lens * Vec3(depth, left * wide * depth, up * high * depth);
    };
    for (int i = 0; i < 4; ++i) {
        pen.line(corner(camera.nearPlane, i), corner(camera.farPlane, i), colour, width);
        for (const double plane : {camera.nearPlane, camera.farPlane})
            pen.line(corner(plane, i), corner(plane, (i + 1) % 4), colour, width);
    }
}

} // namespace

void paintFrusta(QPainter& painter, const ToolView& view, bool all) {
    const ViewportScene& world = view.context().world;
    std::set<const CameraModel*> selected;
    for (const std::string& path : view.context().selection.paths())
        for (const CameraModel* camera : world.camerasOf(path)) selected.insert(camera);
    // Frusta are shown unasked only for a few selected cameras, and not while the view looks through a camera; the overlay shows
    // all.
    if (!all && (selected.empty() || selected.size() > kMaxUnasked || view.camera().through())) return;
    const ScenePainter pen(painter, view);
    const BodyPoses& poses = view.shownPoses();
    std::size_t shown = 0;
    for (const CameraModel& camera : world.cameras()) {
        const bool marked = selected.contains(&camera);
        const auto robot = world.find(camera.robot);
        if ((!all && !marked) || &camera == view.camera().through() || camera.body >= poses.size()) continue;
        if ((robot && world.isHidden(*robot)) || ++shown > kMaxFrusta) continue;
        paintFrustum(pen, camera, poses[camera.body], marked ? ToolView::outlineColour() : kFrustum, marked ? 1.3 : 1);
    }
}

} // namespace trundle
