#include "editor/viewport/tools/library_drop.h"

#include <cmath>
#include <filesystem>

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMimeData>

#include "editor/document/document.h"
#include "editor/document/structure_edits.h"
#include "editor/running/session.h"
#include "editor/viewport/context/scene_painter.h"
#include "editor/viewport/context/tool_view.h"
#include "editor/viewport/context/view_settings.h"
#include "editor/viewport/context/viewport_scene.h"
#include "lang/number_text.h"
#include "lang/tree_edit.h"
#include "project/edits/plans.h"
#include "scene/shapes/extents.h"

namespace trundle {
namespace {

const QString kMime = QStringLiteral("application/x-trundle-library");
const char* const kThing = "droppedThing"; // temporary name while it is dragged
constexpr double kDefaultStep = 0.01;      // m, when snapping is off
constexpr double kFlush = 1e-6;            // m; a part as near as this to the floor rests on it
constexpr double kClearance = 0.005;       // m, between a wheel and the face that it is put on
constexpr double kPartGrain = 1e-4;        // m, of the position of a part
constexpr double kMirrorPixels = 24,
                 kMirrorShare = 0.5; // to the mirror image of another body; of its distance from the middle at most
constexpr double kNearShare = 0.3;   // of half of the extent of a face, to what it has to snap to at most
constexpr double kSteep = 0.5;       // z of the normal of a side face is smaller
constexpr double kSideways = 0.9;    // y of the normal of a left or right face is larger

QString trDrop(const char* text) { return QCoreApplication::translate("LibraryDrop", text); }

std::shared_ptr<const Tree> treeOf(const std::string& text) {
    return parse(std::make_shared<const SourceText>("block", text), 0);
}

/// The first block of that kind. The dragged text may contain further blocks, such as the config of a robot.
const BlockItem* blockOf(const Tree& tree, std::string_view kind) {
    for (const Item& item : tree.items())
        if (const auto* block = item.as<BlockItem>(); block && block->type.text == kind) return block;
    return nullptr;
}

bool hasConfig(const Tree& tree) { return blockOf(tree, "RobotConfig") || blockOf(tree, "StaticConfig"); }

const AssignmentItem* assignmentOf(const BlockItem& block, std::string_view key) {
    for (const Item& item : block.items)
        if (const auto* a = item.as<AssignmentItem>(); a && a->path.size() == 1 && a->path[0].text == key) return a;
    return nullptr;
}

std::string edited(const std::string& text, const TextEdit& edit) {
    const Result<std::string> changed = applyEdits(text, std::span(&edit, 1));
    return changed ? changed.value() : text;
}

std::string withPos(const std::string& text, std::string_view kind, const Vec3& pos) {
    const auto tree = treeOf(text);
    const BlockItem* block = blockOf(*tree, kind);
    if (!block) return text;
    std::string value;
    for (int k = 0; k < 3; ++k) value += (k ? "," : "") + steppedNumber(pos[k], 1e-6);
    const AssignmentItem* a = assignmentOf(*block, "Pos");
    return edited(text, a ? editSetValue(*tree, a->value, value) : editAddAssignment(*tree, block, "Pos", value));
}

std::string withName(const std::string& text, std::string_view kind, const std::string& name) {
    const auto tree = treeOf(text);
    const BlockItem* block = blockOf(*tree, kind);
    if (!block) return text;
    if (block->name) return edited(text, editReplace(*tree, block->name->range, name));
    return edited(text, editReplace(*tree, block->type.range, block->type.text + " " + name));
}

/// The dragged robots and statics only; members of a dragged Grid have names with that prefix.
std::shared_ptr<const ExperimentSpec> objectIn(const ExperimentSpec& experiment) {
    auto alone = std::make_shared<ExperimentSpec>();
    alone->materials = experiment.materials;
    alone->surfaces = experiment.surfaces;
    for (const RobotSpec& robot : experiment.robots)
        if (robot.name.starts_with(kThing) && robot.config) alone->robots.push_back(robot);
    for (const StaticSpec& fixed : experiment.statics)
        if (fixed.name.starts_with(kThing) && fixed.geoms) alone->statics.push_back(fixed);
    return alone->robots.empty() && alone->statics.empty() ? nullptr : alone;
}

} // namespace

bool canDrop(const QMimeData& data) { return data.hasFormat(kMime); }

LibraryDrop::LibraryDrop(ToolView& view, const QMimeData& data, bool shown)
    : m_view(view), m_content(draggedContentOf(data)), m_shown(shown) {
    if (m_content && view.context().document.isOpen()) load();
    else m_content.reset();
}

LibraryDrop::~LibraryDrop() {
    if (m_shown) m_view.context().world.dragged().show(nullptr);
}

std::optional<LibraryDrop::DraggedContent> LibraryDrop::draggedContentOf(const QMimeData& data) {
    const QJsonObject json = QJsonDocument::fromJson(data.data(kMime)).object();
    DraggedContent content{json.value(QStringLiteral("kind")).toString().toStdString(),
                           json.value(QStringLiteral("text")).toString().toStdString(),
                           {},
                           json.value(QStringLiteral("title")).toString(),
                           json.value(QStringLiteral("isTemplate")).toBool()};
    if (content.title.isEmpty()) content.title = QString::fromStdString(content.kind);
    for (const QJsonValue& file : json.value(QStringLiteral("imports")).toArray())
        content.imports.push_back(file.toString().toStdString());
    if (content.text.empty()) return std::nullopt;
    return content;
}

const Kind* LibraryDrop::kind() const {
    return m_content ? m_view.context().document.loaded()->registry->find(m_content->kind) : nullptr;
}

bool LibraryDrop::isWorldObject() const {
    const Kind* kind = this->kind();
    return kind && (kind->role == Role::Instance || kind->role == Role::Layout);
}

/// Loads the dragged text as a file beside the opened one, so that its shapes are available before it is dropped.
void LibraryDrop::load() {
    const Document& document = m_view.context().document;
    const Kind* kind = this->kind();
    const bool isShape = kind && kind->role == Role::Geom, isBody = kind && kind->role == Role::Body;
    if (!isWorldObject() && !isShape && !isBody) return;
    if (isBody) m_part = RobotPart::of(m_content->text);
    const std::string opened = document.loaded()->paths[0], thing = kThing;
    std::string text = withPos(m_content->text, m_content->kind, Vec3::Zero());
    if (isWorldObject()) text = withName(text, m_content->kind, thing);
    else if (isShape) text = "StaticConfig DroppedShape {\n" + text + "\n}\nStatic " + thing + " { Config=DroppedShape }";
    else text = "RobotConfig DroppedParts {\n" + text + "\n}\nRobot " + thing + " { Config=DroppedParts }";
    std::string before;
    for (const std::string& directive : m_content->imports)
        before += (directive.starts_with('#') ? directive : "#import \"" + directive + "\"") + "\n";
    // A text without configs may use those of the opened file, so it imports that file.
    if (before.empty() && !hasConfig(*treeOf(text)))
        before = "#import \"" + std::filesystem::path(opened).filename().string() + "\"\n";
    OpenOptions options = document.options();
    for (const std::string& file : document.texts().files()) options.texts.emplace(file, document.texts().text(file));
    options.texts.insert_or_assign(opened + ".dropped", std::make_shared<const std::string>(before + text + "\n"));
    options.meshesLater = true;
    const auto loaded = m_view.context().session.source().application().open(opened + ".dropped", options);
    if (!loaded) return;
    m_thing = objectIn(*loaded.value()->experiment);
    if (!m_thing) return;
    for (const RobotSpec& robot : m_thing->robots)
        for (const BodySpec& body : robot.config->bodies)
            for (const GeomSpec& geom : body.geoms) m_geoms.push_back({geom, robot.pose * body.pose});
    for (const StaticSpec& fixed : m_thing->statics)
        for (const GeomSpec& geom : *fixed.geoms) m_geoms.push_back({geom, fixed.pose});
    if (m_shown) m_view.context().world.dragged().show(m_thing);
}

LibraryDrop::Ground LibraryDrop::groundAt(const QPointF& at) const {
    Ground ground;
    ground.hits = m_view.context().world.hitsAlong(m_view.camera().rayAt(at), true);
    ground.point = m_view.camera().pointUnder(at);
    return ground;
}

bool LibraryDrop::findOwner(Ground& ground) const {
    const ViewportScene& world = m_view.context().world;
    const Kind* kind = this->kind();
    const RayHit* hit = ground.hit();
    if (!kind || !hit) return false;
    if (const RobotSpec* robot = world.objects()->robotOf(hit->geom); robot && robot->config) {
        const ObjectRef body = *world.objects()->ownerOf(hit->geom);
        const bool intoBody = kind->role == Role::Geom;
        const ObjectRef owner = intoBody ? body : ObjectRef{ObjectKind::Robot, body.instance};
        ground.owner = world.objects()->pathOf(owner);
        ground.frame = world.poseOf(owner);
        ground.isRobot = true;
        if (m_part && (m_part->isWheel || !isUpright())) // a foot is the same from all sides
            ground.turn = m_part->rotationTo(ground.frame.rotation.conjugate() * hit->normal);
        return true;
    }
    const StaticSpec* fixed = world.objects()->staticOf(hit->geom);
    if (!fixed || kind->role != Role::Geom) return false;
    ground.owner = fixed->name;
    ground.frame = fixed->pose;
    return true;
}

std::vector<PlacementGeom> LibraryDrop::turnedGeoms(const Ground& ground) const {
    std::vector<PlacementGeom> turned = m_geoms;
    for (PlacementGeom& part : turned) part.body = Pose{Vec3::Zero(), ground.frame.rotation * ground.turn} * part.body;
    return turned;
}

bool LibraryDrop::isDevice() const {
    const Kind* kind = this->kind();
    return kind && kind->role == Role::Device && kind->find("Body") && kind->find("Pos") && kind->find("HPR");
}

void LibraryDrop::snap(Ground& ground) const {
    const ViewSettings& settings = m_view.context().settings;
    const ObjectIndex& objects = *m_view.context().world.objects();
    if (!settings.snaps() || !ground.hit()) return;
    RayHit& hit = ground.hits.front();
    const RobotSpec* robot = objects.robotOf(hit.geom);
    const GeomSpec* geom = objects.geomOf(hit.geom);
    const auto owner = objects.ownerOf(hit.geom);
    if (!robot || !robot->config || !geom || !owner) return;
    const auto face = FlatFace::of(*geom, m_view.context().world.poseOf(*owner), hit);
    if (!face) return;
    FaceSnapOptions options;
    options.step = settings.moveStep();
    options.origin = m_view.context().world.poseOf({ObjectKind::Robot, owner->instance}).position;
    for (const PlacementGeom& part : turnedGeoms(ground))
        options.thing.add(boundsOf(part.geom, Pose{Vec3::Zero(), face->rotation.conjugate()} * part.body));
    const Mat3 axes = face->rotation.toRotationMatrix();
    for (const int k : {0, 1}) {
        const double most = kNearShare * face->half[std::size_t(k)];
        options.near[std::size_t(k)] = std::min(most, kSnapPixels * m_view.metresPerPixel(hit.point, axes.col(k)));
    }
    ground.snap = snapOnFace(*face, hit.point, options);
    hit.point = ground.snap->point;
}

Vec3 LibraryDrop::placeOn(const Ground& ground) const {
    const ViewportScene& world = m_view.context().world;
    const ViewSettings& settings = m_view.context().settings;
    const double free = settings.snaps() ? settings.moveStep() : kDefaultStep;
    const double step = ground.snap ? 0 : free; // what is snapped stays there
    const std::vector<PlacementGeom> turned = turnedGeoms(ground);
    if (m_part && ground.isRobot) return placePart(ground, turned, step);
    const DropPlacement placement(*world.objects(), *world.poses(), [&](const ObjectRef& geom) { return !world.isHidden(geom); });
    return ground.isRobot && ground.hit() ? placement.placeAgainst(turned, *ground.hit(), step)
                                          : placement.placeFor(turned, ground.hits, ground.point, step);
}

void LibraryDrop::paintGuides(QPainter& painter) const { ScenePainter(painter, m_view).guides(m_guides); }

void LibraryDrop::hover(const QPointF& at) {
    m_guides.clear();
    m_spot.reset();
    if (!m_shown || !(m_thing || isDevice())) return;
    Ground ground = groundAt(at);
    const bool fits = isWorldObject() || isDevice() || findOwner(ground);
    if (!isWorldObject()) snap(ground);
    if (ground.snap) m_guides = ground.snap->guides;
    if (fits && m_part && isUpright() && ground.hit() && std::abs(ground.hit()->normal.z()) < kSteep) // it keeps its height
        std::erase_if(m_guides, [](const auto& line) { return std::abs(line[1].z() - line[0].z()) < kFlush; });
    if (!m_thing) {
        if (ground.hit()) m_spot = ground.hit()->point;
        return;
    }
    m_view.context().world.dragged().moveTo(fits ? std::optional(Pose{placeOn(ground), ground.frame.rotation * ground.turn})
                                                 : std::nullopt);
}

/// Whether the part, as written, rests on the floor.
bool LibraryDrop::isUpright() const {
    Bounds bounds;
    for (const PlacementGeom& part : m_geoms) bounds.add(boundsOf(part.geom, part.body));
    return !bounds.empty() && std::abs(bounds.low.z() + m_part->position.z()) < kFlush;
}

Vec3 LibraryDrop::placePart(const Ground& ground, const std::vector<PlacementGeom>& turned, double step) const {
    const ViewportScene& world = m_view.context().world;
    const Pose& X_WR = ground.frame;
    const Vec3 normal = X_WR.rotation.conjugate() * ground.hit()->normal;
    const bool isSide = std::abs(normal.z()) < kSteep, keepsHeight = isUpright() && (isSide || !m_part->isWheel);
    RayHit hit = *ground.hit();
    const double floor = showsModel(world) ? -X_WR.position.z() : 0; // in R
    Vec3 p_R = X_WR.inverse() * hit.point;
    if (keepsHeight) p_R.z() = floor + m_part->position.z();
    hit.point = X_WR * p_R;
    if (isSide || !keepsHeight) {
        const DropPlacement placement(*world.objects(), *world.poses(), [](const ObjectRef&) { return true; });
        p_R = X_WR.inverse() * placement.placeAgainst(turned, hit, step) + (m_part->isWheel ? kClearance : 0.0) * normal;
    }
    if (keepsHeight) p_R.z() = floor + m_part->position.z();
    for (int k = 0; k < 3; ++k) {
        const double grain = keepsHeight && !isSide && k < 2 && step > 0 ? step : kPartGrain;
        p_R[k] = grain * std::round(p_R[k] / grain) + 0.0;
    }
    Vec3 p_seen = p_R + X_WR.rotation.conjugate() * (ground.point - ground.hit()->point); // without what it has snapped to
    if (keepsHeight) p_seen.z() = p_R.z();
    return X_WR * oppositeOf(ground, p_seen).value_or(p_R);
}

/// The mirror image of a body of the robot, left for right, if that is near in the picture.
std::optional<Vec3> LibraryDrop::oppositeOf(const Ground& ground, const Vec3& p_R) const {
    const ViewportScene& world = m_view.context().world;
    const RobotSpec& robot = *world.objects()->robotOf(ground.hit()->geom);
    const double seen = kMirrorPixels * m_view.metresPerPixel(ground.frame * p_R, cameraAxes(m_view.shownCamera()).col(0));
    std::optional<Vec3> nearest;
    double least = HUGE_VAL;
    for (const BodySpec& body : robot.config->bodies) {
        const Vec3 opposite = body.pose.position.cwiseProduct(Vec3(1, -1, 1));
        const double distance = (opposite - p_R).norm();
        if (distance < std::min({seen, kMirrorShare * std::abs(opposite.y()), least})) nearest = opposite, least = distance;
    }
    return nearest;
}

std::string LibraryDrop::partText(const Ground& ground) const {
    const ViewportScene& world = m_view.context().world;
    const ObjectRef body = *world.objects()->ownerOf(ground.hit()->geom);
    const Vec3 normal = ground.frame.rotation.conjugate() * ground.hit()->normal;
    PartLocation location{{ground.frame.inverse() * placeOn(ground), ground.turn},
                          world.objects()->robotOf(body)->config->bodies[body.body].name,
                          {}};
    if (m_part->isWheel && std::abs(normal.y()) > kSideways) location.side = normal.y() > 0 ? "left" : "right";
    return textAt(m_content->text, *m_part, location);
}

/// A sensor on the face, looking away from it; on top of the robot it looks ahead.
std::string LibraryDrop::deviceText(const Ground& ground) const {
    const ViewportScene& world = m_view.context().world;
    const auto body = world.objects()->ownerOf(ground.hit()->geom);
    const RobotSpec* robot = body ? world.objects()->robotOf(*body) : nullptr;
    if (!robot || !robot->config || !isDevice()) return m_content->text;
    const Pose X_BW = world.poseOf(*body).inverse();
    const Vec3 normal = X_BW.rotation * ground.hit()->normal;
    Pose X_BD{X_BW * ground.hit()->point, Quat::Identity()};
    if (std::abs(normal.z()) < kSteep) X_BD.rotation = Quat(Eigen::AngleAxisd(std::atan2(normal.y(), normal.x()), Vec3::UnitZ()));
    return deviceTextAt(m_content->text, robot->config->bodies[body->body].name, X_BD);
}

void LibraryDrop::refuse(const QString& why) { Q_EMIT m_view.context().document.refused(why); }

void LibraryDrop::drop(const QPointF& at) {
    if (!m_content) return;
    Document& document = m_view.context().document;
    const Kind* kind = this->kind();
    Ground ground = groundAt(at);
    if (!kind && m_content->imports.empty())
        return refuse(trDrop("%1 is unknown here.").arg(QString::fromStdString(m_content->kind)));
    if (!kind || kind->role == Role::Controller) return dropController(ground);
    if (kind->role == Role::Material && dropMaterial(ground)) return;
    std::string parent;
    if (isWorldObject() || kind->role == Role::Geom || kind->role == Role::Body) {
        if (!isWorldObject() && !findOwner(ground))
            return refuse(kind->role == Role::Geom ? trDrop("A shape is part of a robot or an arena: drop it onto one.")
                                                   : trDrop("A body is part of a robot: drop it onto one."));
        if (!isWorldObject()) snap(ground);
        parent = ground.owner;
        if (m_content->isTemplate && kind->role == Role::Geom) m_content->text = templateOf(*document.loaded(), *kind, parent);
        const bool isPart = m_part && ground.isRobot;
        Vec3 place = ground.frame.inverse() * (isPart ? Vec3::Zero() : placeOn(ground));
        if (ground.isRobot) // without the gap that keeps bodies apart
            for (double& p : place) p = kPartGrain * std::round(p / kPartGrain) + 0.0;
        m_content->text = isPart ? partText(ground) : withPos(m_content->text, m_content->kind, place);
    } else if (const RayHit* hit = ground.hit(); hit && kind->role != Role::Material) {
        if (isDevice()) snap(ground);
        const RobotSpec* robot = m_view.context().world.objects()->robotOf(hit->geom);
        if (robot && robot->config) parent = robot->name, m_content->text = deviceText(ground);
    }
    const QString title = trDrop("Insert %1").arg(m_content->title);
    const auto plan = [parent, content = *m_content, isPart = m_part.has_value()](const LoadedProject& loaded,
                                                                                  const StructureEdits::PathMapping& renamed) {
        Result<EditPlan> plan = planInsert(loaded, renamed(parent), content.text, content.imports);
        if (plan && isPart && !plan.value().selects.empty()) plan.value().selects.resize(1); // the body alone
        return plan;
    };
    (void)document.structure().apply(title, {parent}, plan);
}

/// The controller's module may not be loaded; the imports contain the directive that loads it.
void LibraryDrop::dropController(const Ground& ground) {
    const RayHit* hit = ground.hit();
    const RobotSpec* robot = hit ? m_view.context().world.objects()->robotOf(hit->geom) : nullptr;
    if (!robot) return refuse(trDrop("A controller drives a robot: drop it onto one."));
    Document& document = m_view.context().document;
    (void)document.edits().apply(trDrop("Insert %1").arg(m_content->title),
                                 planInsert(*document.loaded(), robot->name, m_content->text, m_content->imports));
}

/// Assigns the material to the shape under the cursor. The material is added by importing its file, or as a block of its own.
bool LibraryDrop::dropMaterial(const Ground& ground) {
    const RayHit* hit = ground.hit();
    if (!hit) return false;
    Document& document = m_view.context().document;
    const auto tree = treeOf(m_content->text);
    const BlockItem* block = blockOf(*tree, m_content->kind);
    if (!block || !block->name) return false;
    const std::string key = "drop " + std::to_string(document.revision());
    const QString title = trDrop("Use material %1").arg(QString::fromStdString(block->name->text));
    if (!document.loaded()->outline->materials.find(block->name->text) &&
        !document.edits().apply(title, planInsert(*document.loaded(), {}, m_content->text, m_content->imports), key))
        return true;
    const std::string path = m_view.context().world.objects()->pathOf(hit->geom);
    if (!document.structure().setValues(title, {{path + ".Material", block->name->text}}, key))
        document.edits().discardMerge(key);
    document.edits().endMerge();
    return true;
}

} // namespace trundle
