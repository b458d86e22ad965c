#include "editor/viewport/gizmo/transform_selection.h"

#include <algorithm>
#include <numbers>

#include <QCoreApplication>

#include "editor/document/selection.h"
#include "editor/document/structure_edits.h"
#include "editor/running/session.h"
#include "editor/viewport/context/view_context.h"
#include "editor/viewport/context/viewport_scene.h"
#include "editor/viewport/gizmo/text_in_place.h"
#include "lang/number_text.h"
#include "model/dotted_path.h"
#include "model/robot_path.h"
#include "project/objects/moves_with.h"
#include "project/objects/object_location.h"
#include "project/objects/part_values.h"
#include "project/objects/written_hpr.h"
#include "scene/shapes/extents.h"

namespace trundle {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;
constexpr double kLeastLength = 1e-3; // m, minimum size that a drag can reach
constexpr const char* kEditedKeys[] = {"Pos", "HPR", "Size", "Radius", "Length"};

QString tr(const char* text) { return QCoreApplication::translate("TransformSelection", text); }

std::array<double, 3> arrayOf(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

std::array<SizeName, 3> sizeNamesOf(GeomShape shape) {
    const QString size = QStringLiteral("Size "), radius = QStringLiteral("Radius"), length = QStringLiteral("Length");
    switch (shape) {
    case GeomShape::Box: return {{{size + u'x'}, {size + u'y'}, {size + u'z'}}};
    case GeomShape::Heightfield: return {{{size + u'x'}, {size + u'y'}, {size + u'z', 1, Sides::Middle}}};
    case GeomShape::Sphere: return {{{radius, 1, Sides::Middle}, {radius, 1, Sides::Middle}, {radius, 1, Sides::Middle}}};
    case GeomShape::Cylinder:
    case GeomShape::Capsule: return {{{radius, 1, Sides::Middle}, {radius, 1, Sides::Middle}, {length}}};
    default: return {};
    }
}

/// Half the sizes that a drag can change (m), along the axes of a geom.
Vec3 halfExtentOf(const GeomSpec& geom) {
    switch (geom.shape) {
    case GeomShape::Box: return 0.5 * geom.size;
    case GeomShape::Sphere: return Vec3::Constant(geom.radius);
    case GeomShape::Cylinder:
    case GeomShape::Capsule: return {geom.radius, geom.radius, 0.5 * geom.length};
    case GeomShape::Heightfield: return {0.5 * geom.size.x(), 0.5 * geom.size.y(), geom.size.z()};
    default: return Vec3::Zero();
    }
}

/// The pose of an object in the frame that contains it, as resolved.
Pose localPose(const ObjectIndex& objects, const ObjectRef& object) {
    if (const GeomSpec* geom = objects.geomOf(object)) return geom->pose;
    const RobotSpec* robot = objects.robotOf(object);
    if (!robot) return objects.staticOf(object)->pose;
    return object.kind == ObjectKind::Robot ? robot->pose : robot->config->bodies[object.body].pose;
}

/// World pose of the frame in which its Pos is written; of a body that a joint has moved, moved with it.
Pose frameAsShown(const ObjectIndex& objects, const ObjectRef& object, const BodyPoses& poses) {
    if (object.kind != ObjectKind::Body) return objects.frameOf(object, poses);
    return objects.poseOf(object, poses) * localPose(objects, object).inverse();
}

/// Pos and HPR of an object after a motion in the world.
Pose movedLocal(const Pose& local, const Pose& frame, const DescribedFrame& described, const Pose& motion) {
    // Applied in the object's own frame, so that unaffected numbers stay exact.
    const Pose inFrame = described.mirrored(frame.inverse() * motion * frame);
    const bool turns = motion.rotation.angularDistance(Quat::Identity()) > 1e-12;
    const Vec3 shift = described.signs.cwiseProduct(frame.rotation.conjugate() * motion.position);
    return {turns ? inFrame * local.position : Vec3(local.position + shift), (inFrame.rotation * local.rotation).normalized()};
}

/// Whether what is inside is described in a frame of its own.
bool holdsFrame(const Part* part) { return part->isPartUse() || part->isRepeat(); }

/// Where an object is, and its Pos and HPR as described.
struct DescribedPose {
    Pose world, frame, local;
    DescribedFrame described;
};
DescribedPose describedPose(const LoadedProject& loaded, const ObjectLocation& place, const ObjectIndex& objects,
                            const ObjectRef& object, const BodyPoses& poses) {
    DescribedPose at{objects.poseOf(object, poses), frameAsShown(objects, object, poses), localPose(objects, object), {}};
    const bool hasIn = valueAt(loaded, place, "In").has_value();
    if (!hasIn && std::ranges::none_of(place.above, holdsFrame)) return at;
    at.described = describedFrame(loaded, place);
    at.frame = at.frame * at.described.pose;
    at.local = at.described.mirrored(at.described.pose.inverse() * at.local);
    return at;
}

QString placedByIndex(const std::string& path) {
    return tr("The members of %1 are each in a place of their own, computed from index. Edit Model (Ctrl+E) moves them all.")
        .arg(QString::fromStdString(path));
}

/// The formulas that edits of these texts replace by numbers: "$gap in robot0.Pos". Empty if they replace none.
QString formulasReplaced(const std::vector<ValueEdit>& edits, const std::map<std::string, std::string>& texts) {
    constexpr qsizetype kMaxNamed = 3;
    QStringList all;
    for (const ValueEdit& edit : edits)
        if (const auto text = texts.find(edit.path.text()); text != texts.end())
            for (const std::string& formula : replacedFormulas(text->second, edit.value.text()))
                all << tr("%1 in %2").arg(QString::fromStdString(formula), QString::fromStdString(text->first));
    if (all.size() > kMaxNamed) all = all.mid(0, kMaxNamed) << tr("%1 more").arg(all.size() - kMaxNamed);
    return all.join(QStringLiteral(", "));
}

QString locked(const std::string& path) { return tr("%1 is locked.").arg(QString::fromStdString(path)); }

} // namespace

TransformSelection::TransformSelection(const ViewContext& context, Operation purpose)
    : m_context(context), m_objects(context.world.objects()), m_running(context.world.isRunning()) {
    const std::vector<std::string>& paths = context.selection.paths();
    for (const std::string& path : paths) {
        if (paths.size() > 1 && m_context.document.isOpen() && movesWith(*m_context.document.loaded(), path, paths)) continue;
        if (isLocked(m_context.world, path)) m_refusal = locked(path);
        else take(path);
        if (purpose == Operation::Scale && !m_running && !m_items.empty() && m_items.back().path == path) addSizes(path);
    }
    if (!m_items.empty()) m_refusal.clear();
}

void TransformSelection::take(const std::string& path) {
    const ViewportScene& world = m_context.world;
    const std::vector<ObjectRef> objects = world.objectsOf(path);
    if (objects.empty()) return takeRegion(path);
    const ObjectRef object = objects.front();
    if (m_running) {
        if (object.kind != ObjectKind::Robot)
            return void(m_refusal = tr("During a run only whole robots can be moved; reset to edit the start."));
        for (const ObjectRef& robot : objects) {
            const Pose at = world.poseOf(robot);
            m_items.push_back({m_objects->pathOf(robot), robot, at, Pose{}, at, {}, {}});
        }
        return;
    }
    if (!m_context.document.isOpen()) return;
    const auto place = placeOf(*m_context.document.loaded(), path);
    const bool hasPlace = place && (place->member || (place->part && place->part->kind && place->part->kind->find("Pos")));
    if (!hasPlace) return; // a whole config has no pose
    if (place->member) {
        m_layout = layoutMemberIn(*m_context.document.loaded()->outline, path).all();
        return void(m_refusal = tr("%1 is a member of %2, which sets its pose.")
                                    .arg(QString::fromStdString(path), QString::fromStdString(m_layout)));
    }
    if (isPlacedByIndex(*m_context.document.loaded(), path, *place)) return void(m_refusal = placedByIndex(path));
    if (place->part && holdsFrame(place->part)) return takePart(path, *place, object);
    const bool isAllOfRepeat = !place->around.empty() && place->members.empty(); // they have one text
    const std::string one = isAllOfRepeat ? m_objects->pathOf(object) : path;
    if (isAllOfRepeat && place->part->is(Role::Layout)) return take(std::string(memberName(one)->stem));
    if (one != path) return take(one);
    if (place->instance && place->within.empty() && !world.find(path)) return takePart(path, *place, object);
    if (world.isLocked(object)) return void(m_refusal = locked(path)); // reached through a config
    const LoadedProject& loaded = *m_context.document.loaded();
    const ObjectRef shown = objectWithTexts(loaded, path, *m_objects, objects, kEditedKeys);
    const DescribedPose at = describedPose(loaded, *place, *m_objects, shown, *world.poses());
    Item item{path, shown, at.world, at.frame, at.local, at.described};
    if (!hasTextsOf(loaded, path, m_objects->pathOf(shown), kEditedKeys)) { // every instance has values of its own
        item.local = poseAt(loaded, *place);
        item.world = item.frame * item.described.mirrored(item.local);
        if (const GeomSpec* geom = m_objects->geomOf(shown)) item.shape = sizedByText(loaded, *place, *geom);
    }
    add(std::move(item), *place);
}

void TransformSelection::add(Item item, const ObjectLocation& place) {
    item.posText = textOf(item.path + ".Pos");
    item.hprText = textOf(item.path + ".HPR");
    m_texts[item.path + ".Pos"] = item.posText;
    m_texts[item.path + ".HPR"] = item.hprText;
    item.hpr = writtenHpr(*m_context.document.loaded(), place, item.local.rotation);
    m_items.push_back(std::move(item));
}

void TransformSelection::takeRegion(const std::string& path) {
    if (!m_context.document.isOpen()) return;
    const LoadedProject& loaded = *m_context.document.loaded();
    const auto place = placeOf(loaded, path);
    if (!place || !place->part || !place->part->is(Role::Region)) return;
    if (m_running) return void(m_refusal = tr("During a run only whole robots can be moved; reset to edit the start."));
    if (isPlacedByIndex(loaded, path, *place)) return void(m_refusal = placedByIndex(path));
    const auto size = valueAt(loaded, *place, "Size");
    if (!size || size->numbers.size() != 3) return;
    const DescribedFrame described = describedFrame(loaded, *place);
    const Pose local = poseAt(loaded, *place);
    Item item{path, std::nullopt, described.pose * local, described.pose, local, described};
    item.shape = GeomSpec{};
    item.shape->shape = GeomShape::Box;
    item.shape->size = {size->numbers[0], size->numbers[1], size->numbers[2]};
    add(std::move(item), *place);
}

void TransformSelection::addSizes(const std::string& path) {
    Item& item = m_items.back();
    if (const auto place = placeOf(*m_context.document.loaded(), path); place && place->part && holdsFrame(place->part)) return;
    const std::vector<ObjectRef> members = item.object ? std::vector<ObjectRef>() : m_context.world.objectsOf(path);
    m_layoutExtent.reset();
    if (!members.empty()) {
        const auto textOfKey = [&](const std::string& key) { return textOf(path + "." + key); };
        m_layoutExtent = LayoutExtent::of(*m_context.document.loaded(), *placeOf(*m_context.document.loaded(), path), textOfKey);
        m_layoutItem = {item};
        m_memberReach = 0.5 * m_context.world.boundsOf(members.front()).size().head<2>().maxCoeff();
        item.world = m_context.world.poseOf(members.front()); // the handles of the first member scale all
    }
    if (members.empty() && (!item.object || (item.object->kind != ObjectKind::Robot && item.object->kind != ObjectKind::Static)))
        return;
    item.sizes = ParamSizes::of(*m_context.document.loaded(), path);
    const std::string shape = item.sizes ? item.sizes->onlyShape() : std::string();
    if (shape.empty()) return;
    m_items.pop_back();
    take(path + "." + shape);
}

void TransformSelection::takePart(const std::string& path, const ObjectLocation& place, const ObjectRef& inside) {
    const LoadedProject& loaded = *m_context.document.loaded();
    const ObjectRef whole = m_objects->wholeOf(inside);
    Item item{path, std::nullopt, {}, {}, poseAt(loaded, place), describedFrame(loaded, place)};
    const bool isInWorld = place.part->isInWorld || place.part->is(Role::Layout);
    const bool isInBody = std::ranges::any_of(place.above, [](const Part* part) { return part->is(Role::Body); });
    const Pose around = isInBody ? frameAsShown(*m_objects, inside, *m_context.world.poses()) : m_context.world.poseOf(whole);
    item.frame = isInWorld ? item.described.pose : around * item.described.pose;
    item.world = item.frame * item.described.mirrored(item.local);
    add(std::move(item), place);
}

std::string TransformSelection::textOf(const std::string& property) const {
    return textInPlace(*m_context.document.loaded(), property);
}

QString TransformSelection::title() const {
    return m_items.size() == 1 ? QString::fromStdString(m_items.front().path)
                               : QCoreApplication::translate("TransformSelection", "%n objects", nullptr, int(m_items.size()));
}

std::vector<std::string> TransformSelection::paths() const {
    std::vector<std::string> all;
    for (const Item& item : m_items) all.push_back(item.path);
    return all;
}

Bounds TransformSelection::boundsOf(std::size_t item) const {
    if (m_items[item].object) return m_objects->boundsOf(*m_items[item].object, *m_context.world.poses());
    if (const auto& region = m_items[item].shape) return trundle::boundsOf(*region, m_items[item].world);
    Bounds all;
    for (const ObjectRef& member : m_context.world.objectsOf(m_items[item].path)) all.add(m_context.world.boundsOf(member));
    return all;
}

std::vector<ValueEdit> TransformSelection::editsOf(Item& item, const Pose& local, DragFineness fineness) const {
    std::vector<ValueEdit> edits;
    // Once a drag has edited a property it keeps writing it, even when it returns to the start.
    item.posEdited |= (item.local.position - local.position).cwiseAbs().maxCoeff() > 1e-9;
    item.hprEdited |= item.local.rotation.angularDistance(local.rotation) > 1e-7;
    const auto before = arrayOf(item.local.position), after = arrayOf(local.position);
    if (item.posEdited) edits.push_back({item.path + ".Pos", withNumbers(item.posText, before, after, "m", fineness.lengthM)});
    const auto from = arrayOf(item.hpr * kDegrees), to = arrayOf(hprLike(item.hpr, local.rotation) * kDegrees);
    if (item.hprEdited) edits.push_back({item.path + ".HPR", withNumbers(item.hprText, from, to, "deg", fineness.degrees)});
    return edits;
}

Status TransformSelection::apply(const std::vector<ValueEdit>& edits, const QString& name, const std::string& mergeKey) {
    const auto same = [](const ValueEdit& a, const ValueEdit& b) { return a.path == b.path && a.value == b.value; };
    if (edits.empty() || std::equal(edits.begin(), edits.end(), m_last.begin(), m_last.end(), same)) return {};
    Status done = m_context.document.structure().setValues(name, edits, mergeKey);
    if (!done) return done;
    m_last = edits;
    // After each step of a drag, since a change of the document removes the notice.
    if (const QString formulas = formulasReplaced(edits, m_texts); !formulas.isEmpty())
        Q_EMIT m_context.document.notice(tr("Replaced by numbers: %1").arg(formulas));
    return done;
}

Status TransformSelection::move(const Pose& motion, const QString& name, const std::string& mergeKey, DragFineness fineness) {
    if (m_running) {
        for (const Item& item : m_items)
            if (!m_context.session.robots().place(item.path, motion * item.world))
                return Error{Code::EditRefused, "it cannot be placed there"};
        return {};
    }
    std::vector<ValueEdit> edits;
    for (Item& item : m_items)
        for (ValueEdit& edit : editsOf(item, movedLocal(item.local, item.frame, item.described, motion), fineness))
            edits.push_back(std::move(edit));
    return apply(edits, name, mergeKey);
}

Status TransformSelection::moveEach(const std::vector<Vec3>& offsets, const QString& name) {
    std::vector<ValueEdit> edits;
    for (std::size_t i = 0; i < m_items.size() && i < offsets.size(); ++i) {
        Item& item = m_items[i];
        if (m_running) {
            Pose to = item.world;
            to.position += offsets[i];
            if (!m_context.session.robots().place(item.path, to)) return Error{Code::EditRefused, "it cannot be placed there"};
            continue;
        }
        const Pose local = movedLocal(item.local, item.frame, item.described, {offsets[i], Quat::Identity()});
        for (ValueEdit& edit : editsOf(item, local, {})) edits.push_back(std::move(edit));
    }
    m_context.document.edits().endMerge();
    return apply(edits, name, {});
}

Vec3 TransformSelection::sizeCentre() const {
    const Item& pivot = m_items.back();
    return pivot.sizes ? pivot.world * pivot.sizes->box().centre() : pivot.world.position;
}

const GeomSpec* TransformSelection::shapeOf(const Item& item) const {
    if (item.shape) return &*item.shape;
    return item.object ? m_objects->geomOf(*item.object) : nullptr;
}

QString TransformSelection::sizeRefusal() const {
    if (m_layoutExtent && !m_items.empty() && halfExtent().isZero()) return {}; // it has handles of its own
    return !m_items.empty() && m_items.back().sizes ? m_items.back().sizes->refusal() : QString();
}

Vec3 TransformSelection::halfExtent() const {
    if (const auto& sizes = m_items.back().sizes) {
        Vec3 half = 0.5 * sizes->box().size();
        for (int k = 0; k < 3; ++k)
            if (!sizes->canSize(k)) half[k] = 0;
        return half;
    }
    const GeomSpec* geom = shapeOf(m_items.back());
    return m_running || !geom ? Vec3(Vec3::Zero()) : halfExtentOf(*geom);
}

std::array<SizeName, 3> TransformSelection::sizeNames() const {
    if (const auto& sizes = m_items.back().sizes) {
        std::array<SizeName, 3> names{{sizes->sizeName(0), sizes->sizeName(1), sizes->sizeName(2)}};
        for (SizeName& name : names)
            if (!m_items.back().object && name.sides == Sides::Both) name.sides = Sides::Middle; // members keep their positions
        return names;
    }
    const GeomSpec* geom = shapeOf(m_items.back());
    return geom ? sizeNamesOf(geom->shape) : std::array<SizeName, 3>();
}

void TransformSelection::follow(Item& item, const Vec3& before, const Vec3& after, int side,
                                std::vector<ValueEdit>& edits) const {
    Pose local = item.local;
    local.position += item.local.rotation * item.described.signs.cwiseProduct(0.5 * side * (after - before));
    for (ValueEdit& edit : editsOf(item, local, {})) edits.push_back(std::move(edit));
}

void TransformSelection::resizeByParam(Item& item, const Vec3& growth, int side, double fineness, std::vector<ValueEdit>& edits) {
    const ParamSizes& sizes = *item.sizes;
    int axis = item.sizedAxis;
    for (int k = 0; k < 3; ++k)
        if (growth[k] != 0) axis = k;
    if (axis < 0 || !sizes.canSize(axis)) return;
    item.sizedAxis = axis; // so that returning to the original size still updates the written value
    const Bounds& box = sizes.box();
    const double extent = std::max(kLeastLength, box.size()[axis] + 2 * growth[axis]);
    const ParamSizes::Change change = sizes.resized(axis, extent, fineness);
    edits.push_back({item.path + "." + change.param, change.text});
    m_texts.try_emplace(edits.back().path.text(), change.before);
    if (!item.object || sizes.sizeName(axis).sides != Sides::Both) return;
    Vec3 shift = Vec3::Zero();
    shift[axis] = side > 0   ? box.low[axis] - change.box.low[axis]
                  : side < 0 ? box.high[axis] - change.box.high[axis]
                             : box.centre()[axis] - change.box.centre()[axis];
    Pose local = item.local;
    local.position += item.local.rotation * shift;
    for (ValueEdit& edit : editsOf(item, local, {})) edits.push_back(std::move(edit));
}

Status TransformSelection::resize(const Vec3& growth, int side, const QString& name, const std::string& mergeKey,
                                  DragFineness fineness) {
    std::vector<ValueEdit> edits;
    for (Item& item : m_items)
        if (item.sizes) resizeByParam(item, growth, side, fineness.lengthM, edits);
        else if (const GeomSpec* geom = shapeOf(item)) resizeGeom(item, *geom, growth, side, fineness.lengthM, edits);
    return apply(edits, name, mergeKey);
}

Status TransformSelection::resizeLayout(const Vec3& growth, int side, const QString& name, const std::string& mergeKey,
                                        DragFineness fineness) {
    if (!m_layoutExtent) return {};
    const LayoutExtent::Change change = m_layoutExtent->grown(growth, side, fineness.lengthM);
    Item& item = m_layoutItem.front();
    std::vector<ValueEdit> edits{{item.path + "." + change.key, change.text}};
    m_texts.try_emplace(edits[0].path.text(), textOf(edits[0].path.text()));
    Pose local = item.local;
    local.position += item.local.rotation * change.shift;
    for (ValueEdit& edit : editsOf(item, local, {})) edits.push_back(std::move(edit));
    return apply(edits, name, mergeKey);
}

void TransformSelection::resizeGeom(Item& item, const GeomSpec& geom, const Vec3& growth, int side, double fineness,
                                    std::vector<ValueEdit>& edits) {
    const auto set = [&](const char* key, std::span<const double> before, std::span<const double> after) {
        const std::string path = item.path + "." + key;
        const std::string& text = m_texts.try_emplace(path, textOf(path)).first->second;
        edits.push_back({path, withNumbers(text, before, after, "m", fineness)});
    };
    // The value as it will be rounded in the text; Pos is computed from it.
    const auto grown = [&](double value, double by) {
        const double to = std::max(kLeastLength, value + by);
        return by == 0 ? value : std::max(kLeastLength, fineness * std::round(to / fineness));
    };
    const double radius = geom.radius, length = geom.length;
    const double across = std::abs(growth.x()) > std::abs(growth.y()) ? growth.x() : growth.y();
    switch (geom.shape) {
    case GeomShape::Box:
    case GeomShape::Heightfield: {
        const bool onBase = geom.shape == GeomShape::Heightfield; // its Pos is at the centre of its base
        Vec3 size = geom.size;
        for (int k = 0; k < 3; ++k) size[k] = grown(size[k], (onBase && k == 2 ? 1 : 2) * growth[k]);
        set("Size", arrayOf(geom.size), arrayOf(size));
        const Vec3 moving(1, 1, onBase ? 0 : 1);
        follow(item, geom.size.cwiseProduct(moving), size.cwiseProduct(moving), side, edits);
        break;
    }
    case GeomShape::Sphere: {
        const double by = std::abs(across) > std::abs(growth.z()) ? across : growth.z(), to = grown(radius, by);
        set("Radius", {&radius, 1}, {&to, 1});
        break;
    }
    case GeomShape::Cylinder:
    case GeomShape::Capsule: {
        const double wide = grown(radius, across), far = grown(length, 2 * growth.z());
        if (across != 0 || m_texts.contains(item.path + ".Radius")) set("Radius", {&radius, 1}, {&wide, 1});
        if (growth.z() != 0 || m_texts.contains(item.path + ".Length")) set("Length", {&length, 1}, {&far, 1});
        follow(item, {0, 0, length}, {0, 0, far}, side, edits);
        break;
    }
    default: break;
    }
}

} // namespace trundle
