#include "editor/viewport/tools/arrange.h"

#include <algorithm>
#include <numeric>

#include <QCoreApplication>

#include "editor/document/document.h"
#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/transform_selection.h"
#include "lang/edit_style.h"
#include "lang/number_text.h"
#include "lang/tree_edit.h"
#include "project/edits/plan_copies.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

constexpr double kInset = 0.02, kAbove = 0.001; // fraction of the footprint; m
constexpr int kMaxCopies = 400;

QString trArrange(const char* text) { return QCoreApplication::translate("Arrange", text); }

void refuse(const ViewContext& context, const QString& why) { Q_EMIT context.document.refused(why); }

/// True if at least `least` objects can be arranged; otherwise reports the reason.
bool usable(const ViewContext& context, const TransformSelection& held, std::size_t least) {
    if (held.paths().size() >= least) return true;
    refuse(context, !held.refusal().isEmpty() ? held.refusal()
                    : least == 1              ? trArrange("Select the objects to drop to the floor.")
                    : least == 2              ? trArrange("Select two or more objects.")
                                              : trArrange("Select three or more objects."));
    return false;
}

/// Height of the highest surface below a box, ignoring the object itself; 0 if there is none.
double groundBelow(const ViewContext& context, const Bounds& box, const std::vector<ObjectRef>& itself) {
    const ViewportScene& world = context.world;
    const auto isItself = [&](const ObjectRef& geom) {
        for (std::optional<ObjectRef> object = geom; object; object = world.objects()->ownerOf(*object))
            if (std::find(itself.begin(), itself.end(), *object) != itself.end()) return true;
        return false;
    };
    double ground = -std::numeric_limits<double>::infinity();
    const Vec3 middle = box.centre(), half = (0.5 - kInset) * box.size();
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}}) {
        const Vec3 from(middle.x() + x * half.x(), middle.y() + y * half.y(), box.high.z() + kAbove);
        for (const RayHit& hit : world.hitsAlong({from, -Vec3::UnitZ()}, true)) {
            if (isItself(hit.geom)) continue;
            ground = std::max(ground, hit.point.z());
            break;
        }
    }
    return std::isfinite(ground) ? ground : 0;
}

} // namespace

void dropToFloor(const ViewContext& context) {
    TransformSelection held(context);
    if (!usable(context, held, 1)) return;
    std::vector<Vec3> offsets;
    const std::vector<std::string> paths = held.paths();
    for (std::size_t i = 0; i < paths.size(); ++i) {
        const Bounds box = held.boundsOf(i);
        const double by = box.empty() ? 0 : groundBelow(context, box, context.world.objectsOf(paths[i])) - box.low.z();
        offsets.emplace_back(0, 0, by);
    }
    (void)held.moveEach(offsets, trArrange("Drop %1 to floor").arg(held.title()));
}

void alignSelected(const ViewContext& context, int axis, AlignTo to) {
    TransformSelection held(context);
    if (!usable(context, held, 2)) return;
    const auto mark = [&](std::size_t i) {
        const Bounds box = held.boundsOf(i);
        if (box.empty()) return std::optional<double>();
        return std::optional(to == AlignTo::Low ? box.low[axis] : to == AlignTo::High ? box.high[axis] : box.centre()[axis]);
    };
    const std::size_t count = held.paths().size();
    const auto wanted = mark(count - 1);
    std::vector<Vec3> offsets(count, Vec3::Zero());
    for (std::size_t i = 0; i < count && wanted; ++i)
        if (const auto now = mark(i)) offsets[i][axis] = *wanted - *now;
    (void)held.moveEach(offsets, trArrange("Align %1").arg(held.title()));
}

void distributeSelected(const ViewContext& context, int axis) {
    TransformSelection held(context);
    if (!usable(context, held, 3)) return;
    const std::size_t count = held.paths().size();
    std::vector<double> middles;
    for (std::size_t i = 0; i < count; ++i) middles.push_back(held.boundsOf(i).empty() ? 0 : held.boundsOf(i).centre()[axis]);
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return middles[a] < middles[b]; });
    const double first = middles[order.front()], step = (middles[order.back()] - first) / double(count - 1);
    std::vector<Vec3> offsets(count, Vec3::Zero());
    for (std::size_t k = 0; k < count; ++k) offsets[order[k]][axis] = first + step * double(k) - middles[order[k]];
    (void)held.moveEach(offsets, trArrange("Distribute %1").arg(held.title()));
}

namespace {

/// Pose of a Robot or Static in its text; nullptr for everything else.
const Pose* poseInText(const ObjectIndex& objects, const ObjectRef& object) {
    if (object.kind == ObjectKind::Robot) return &objects.robotOf(object)->pose;
    return object.kind == ObjectKind::Static ? &objects.staticOf(object)->pose : nullptr;
}

} // namespace

QString gridRefusal(const ViewContext& context) {
    const std::vector<std::string>& paths = context.selection.paths();
    const auto object = paths.size() == 1 ? context.world.find(paths[0]) : std::nullopt;
    if (!object || !poseInText(*context.world.objects(), *object))
        return trArrange("A Grid is made of one robot or one piece of scenery.");
    const auto place = placeOf(*context.document.loaded(), paths[0]);
    if (place && !place->around.empty())
        return trArrange("%1 is in %2, which makes several of it. A Grid is made of one that is in no Repeat.")
            .arg(QString::fromStdString(paths[0]), QString::fromStdString(place->around.back()->name));
    return !place || place->member || !place->part
               ? trArrange("%1 is part of a Grid already.").arg(QString::fromStdString(paths[0]))
               : QString();
}

bool gridIsTurned(const ViewContext& context) {
    if (!gridRefusal(context).isEmpty()) return false;
    const Pose& pose = *poseInText(*context.world.objects(), *context.world.find(context.selection.current()));
    return pose.rotation.angularDistance(Quat::Identity()) > 1e-6;
}

namespace {

/// Replaces a Robot or Static by a Grid whose first member has its pose.
void makeGrid(const ViewContext& context, const ArrayCopy& copy) {
    const std::string path = context.selection.current();
    const LoadedProject& loaded = *context.document.loaded();
    const auto place = placeOf(loaded, path);
    const Part& part = *place->part;
    const Tree& tree = *loaded.trees[part.file];
    const Pose& pose = *poseInText(*context.world.objects(), *context.world.find(path));
    const Vec3 centre =
        pose * Vec3(0.5 * (copy.count[0] - 1) * copy.spacing.x(), 0.5 * (copy.count[1] - 1) * copy.spacing.y(), 0);
    std::string pos;
    for (int k = 0; k < 3; ++k) pos += (k ? "," : "") + steppedNumber(centre[k], 1e-6);
    std::vector<TextEdit> edits{editReplace(tree, part.block->type.range, "Grid")};
    const SourceAssignment* old = part.assignments.find("Pos");
    const std::string count = std::to_string(copy.count[0]) + "," + std::to_string(copy.count[1]);
    const std::string spacing =
        steppedNumber(std::abs(copy.spacing.x()), 1e-6) + "," + steppedNumber(std::abs(copy.spacing.y()), 1e-6);
    const bool spaced = spacedEquals(tree, part.block, editStyle(tree));
    const auto assignment = [&](const char* key, const std::string& value) {
        return std::string(" ") + key + (spaced ? " = " : "=") + value;
    };
    if (old && old->file == part.file) {
        edits.push_back(editSetValue(tree, *old->value, pos));
        const std::uint32_t end = old->value->range.end;
        edits.push_back({{part.file, {end, end}}, assignment("Count", count) + assignment("Spacing", spacing)});
    } else {
        const std::uint32_t open = part.block->open.end;
        edits.push_back(
            {{part.file, {open, open}}, assignment("Pos", pos) + assignment("Count", count) + assignment("Spacing", spacing)});
    }
    (void)context.document.edits().edit(trArrange("Array copy of %1").arg(QString::fromStdString(path)), {{part.file, edits}});
}

} // namespace

namespace {

/// All copies of these objects, behind their originals. Selects the originals and the copies.
Result<EditPlan> planRows(const LoadedProject& loaded, const std::vector<std::string>& originals, const ArrayCopy& copy,
                          const StructureEdits::PathMapping& renamed) {
    std::vector<std::string> paths;
    for (const std::string& original : originals) paths.push_back(renamed(original));
    std::vector<Vec3> offsets;
    for (int i = 1; i < copy.count[0] * copy.count[1] * copy.count[2]; ++i)
        offsets.push_back(Vec3(i % copy.count[0], i / copy.count[0] % copy.count[1], i / (copy.count[0] * copy.count[1]))
                              .cwiseProduct(copy.spacing));
    Result<EditPlan> plan = planCopies(loaded, paths, offsets);
    if (plan.ok()) plan.value().selects.insert(plan.value().selects.begin(), paths.begin(), paths.end());
    return plan;
}

} // namespace

void copyInRows(const ViewContext& context, const ArrayCopy& copy) {
    if (!context.document.isOpen()) return;
    if (copy.asGrid) {
        if (const QString why = gridRefusal(context); !why.isEmpty()) return refuse(context, why);
        return makeGrid(context, copy);
    }
    const std::vector<std::string> originals = context.selection.paths();
    if (originals.empty()) return refuse(context, trArrange("Select what is to be copied."));
    const long total = long(copy.count[0]) * copy.count[1] * copy.count[2];
    if (total > kMaxCopies)
        return refuse(
            context,
            trArrange("That would be %1 copies; at most %2 are made, a Grid can hold more.").arg(total - 1).arg(kMaxCopies));
    for (const std::string& path : originals) {
        const auto place = placeOf(*context.document.loaded(), path);
        if (place && !place->member) continue;
        return refuse(context, trArrange("%1 has no text of its own to copy.").arg(QString::fromStdString(path)));
    }
    context.document.edits().endMerge();
    const QString title = originals.size() == 1 ? trArrange("Array copy of %1").arg(QString::fromStdString(originals.front()))
                                                : trArrange("Array copy of %1 objects").arg(originals.size());
    (void)context.document.structure().apply(title, originals,
                                             [originals, copy](const LoadedProject& loaded, const auto& renamed) {
                                                 return planRows(loaded, originals, copy, renamed);
                                             });
}

} // namespace trundle
