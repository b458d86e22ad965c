#include "editor/viewport/tools/object_drop.h"

#include <algorithm>

#include <QCoreApplication>
#include <QMimeData>

#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/transform_selection.h"
#include "project/edits/plans.h"
#include "scene/queries/drop_placement.h"

namespace trundle {
namespace {

const QString kRowsMime = QStringLiteral("application/x-trundle-objects"); // id of the source tree, then one path per line
constexpr double kFreeStep = 0.01, kLevel = 0.002; // m; step without snapping; vertical moves below kLevel are ignored

/// Point of the plane z = 0 under a pixel, ignoring objects.
Vec3 groundUnder(const ToolView& view, const QPointF& at) {
    const ViewRay ray = view.camera().rayAt(at);
    const double down = -ray.origin.z() / ray.direction.z();
    if (std::isfinite(down) && down > 0) return ray.origin + down * ray.direction;
    return view.camera().pointUnder(at);
}

/// Adds the geoms of an object at their current poses, relative to `from`.
void addGeoms(const ViewportScene& world, const ObjectRef& object, const Vec3& from, std::vector<PlacementGeom>& out) {
    const ObjectIndex& objects = *world.objects();
    const auto add = [&](const std::vector<GeomSpec>& geoms, Pose owner) {
        owner.position -= from;
        for (const GeomSpec& geom : geoms) out.push_back({geom, owner});
    };
    if (const GeomSpec* geom = objects.geomOf(object)) return add({*geom}, objects.frameOf(object, *world.poses()));
    if (const StaticSpec* fixed = objects.staticOf(object)) return fixed->geoms ? add(*fixed->geoms, fixed->pose) : void();
    const RobotSpec* robot = objects.robotOf(object);
    for (std::uint32_t i = 0; robot->config && i < robot->config->bodies.size(); ++i)
        if (object.kind == ObjectKind::Robot || object.body == i)
            add(robot->config->bodies[i].geoms, world.poseOf({ObjectKind::Body, object.instance, i}));
}

/// Displacement of the object selected last to its drop position.
Vec3 wayTo(const ToolView& view, const QPointF& at, const TransformSelection& held) {
    const ViewContext& context = view.context();
    std::vector<ObjectRef> moved;
    const std::vector<std::string> paths = held.paths();
    for (const std::string& path : paths)
        for (const ObjectRef& object : context.world.objectsOf(path)) moved.push_back(object);
    const ViewportScene& world = context.world;
    const Vec3 from = held.pivot().position;
    const double step = context.settings.snaps() ? context.settings.moveStep() : kFreeStep;
    std::vector<PlacementGeom> geoms; // of the object selected last
    for (const ObjectRef& object : world.objectsOf(paths.back())) addGeoms(world, object, from, geoms);
    const auto counts = [&](const ObjectRef& geom) {
        std::optional<ObjectRef> object = geom;
        while (object && std::find(moved.begin(), moved.end(), *object) == moved.end())
            object = world.objects()->ownerOf(*object);
        return !object && !world.isHidden(geom);
    };
    const DropPlacement placement(*world.objects(), *world.poses(), counts);
    Vec3 way = placement.placeFor(geoms, world.hitsAlong(view.camera().rayAt(at), true), groundUnder(view, at), step) - from;
    if (std::abs(way.z()) < kLevel) way.z() = 0; // keeps the exact number in the text
    return way;
}

void refuse(const ToolView& view, const TransformSelection& held) { Q_EMIT view.context().document.refused(held.refusal()); }

QString trObject(const char* text) { return QCoreApplication::translate("ObjectDrop", text); }

} // namespace

bool canMoveHere(const ToolView& view, const QMimeData& data) {
    const QByteArrayList lines = data.data(kRowsMime).split('\n');
    if (!lines.front().startsWith(QByteArray::number(QCoreApplication::applicationPid()) + ' ')) return false;
    const std::vector<std::string>& selected = view.context().selection.paths();
    const auto isSelected = [&](const QByteArray& path) {
        return path.isEmpty() || std::find(selected.begin(), selected.end(), path.toStdString()) != selected.end();
    };
    if (!std::all_of(lines.begin() + 1, lines.end(), isSelected)) return false;
    const TransformSelection held(view.context());
    return !held.empty() || !held.refusal().isEmpty();
}

void moveHere(ToolView& view, const QPointF& at) {
    TransformSelection held(view.context());
    if (held.empty()) return refuse(view, held);
    const std::vector<Vec3> offsets(held.paths().size(), wayTo(view, at, held));
    (void)held.moveEach(offsets, trObject("Move %1").arg(held.title()));
}

void copyHere(ToolView& view, const QPointF& at) {
    const TransformSelection held(view.context());
    if (held.empty()) return refuse(view, held);
    const Vec3 inFrame = held.pivotFrame().rotation.conjugate() * wayTo(view, at, held);
    const auto plan = [paths = held.paths(), inFrame](const LoadedProject& loaded, const StructureEdits::PathMapping& renamed) {
        std::vector<std::string> now;
        for (const std::string& path : paths) now.push_back(renamed(path));
        return planDuplicate(loaded, now, inFrame);
    };
    (void)view.context().document.structure().apply(trObject("Copy %1").arg(held.title()), held.paths(), plan);
}

} // namespace trundle
