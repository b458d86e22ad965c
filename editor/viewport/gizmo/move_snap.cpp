#include "editor/viewport/gizmo/move_snap.h"

#include <algorithm>

#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/gizmo_drag.h"
#include "editor/viewport/gizmo/transform_selection.h"
#include "project/objects/moves_with.h"

namespace trundle {
namespace {

constexpr double kFinePixels = 10; // steps that are seen closer together than this yield to what is near

/// The bodies and geoms that are dragged, of the robot or static of the object selected last; none if that is dragged itself.
std::vector<ObjectRef> objectsIn(const ViewportScene& world, const TransformSelection& dragged) {
    std::vector<std::string> paths = dragged.paths();
    std::ranges::reverse(paths);
    std::vector<ObjectRef> moved;
    for (const std::string& path : paths)
        for (const ObjectRef& object : world.objectsOf(path)) {
            const ObjectRef whole = world.objects()->wholeOf(object);
            if (whole == object) return {};
            if (moved.empty() || whole == world.objects()->wholeOf(moved.front())) moved.push_back(object);
        }
    return moved;
}

} // namespace

MoveSnap::MoveSnap(const ToolView& view, const TransformSelection& dragged, const Mat3& axes) : m_view(view) {
    const ViewContext& context = view.context();
    const ObjectIndex& objects = *context.world.objects();
    if (dragged.isRunning() || !context.document.isOpen()) return;
    const std::vector<ObjectRef> moved = objectsIn(context.world, dragged);
    std::vector<std::string> paths;
    for (const ObjectRef& object : moved) paths.push_back(objects.pathOf(object));
    const auto counts = [&](const ObjectRef& geom) {
        return !context.world.isHidden(geom) && !movesWith(*context.document.loaded(), objects.pathOf(geom), paths);
    };
    m_extents = SnapExtents::of(objects, *context.world.poses(), moved, counts, axes);
}

void MoveSnap::apply(GizmoDrag& drag, const Vec3& origin) {
    const double step = m_view.context().settings.moveStep();
    ExtentSnapOptions options{drag.unsnapped(), drag.amount()};
    for (int k = 0; k < 3; ++k) {
        if (!drag.isAlong(k)) continue;
        const double metres = m_view.metresPerPixel(origin, m_extents.axes.col(k));
        options.near[k] = kSnapPixels * metres;
        options.favour[k] = step < kFinePixels * metres ? 0.5 * kFinePixels * metres : 0;
    }
    ExtentSnap snap = snapExtents(m_extents, options);
    drag.snapTo(snap.by);
    m_guides = std::move(snap.guides);
}

void MoveSnap::paint(QPainter& painter) const { ScenePainter(painter, m_view).guides(m_guides); }

} // namespace trundle
