#include "editor/viewport/context/viewport_scene.h"

#include <algorithm>

#include <QSignalBlocker>

#include "editor/document/document.h"
#include "editor/running/session.h"
#include "model/robot_path.h"
#include "project/objects/object_location.h"
#include "scene/queries/ghosts.h"

namespace trundle {
namespace {

/// What `part` has after the words of `name`, of which a member of a Repeat is named by that too: of "roller.rim" it is "rim"
/// after "roller_3", unless there is an object `roller`. Empty: what has the name is it, or in it. Nothing if it leads elsewhere.
/// Both are inside `around`.
std::optional<std::string_view> restInside(const ObjectIndex& objects, std::string_view name, std::string_view part,
                                           std::string around = {}) {
    for (; !part.empty() && !name.empty(); part = withoutFirstWord(part), name = withoutFirstWord(name)) {
        const std::string_view word = firstWord(name), wanted = firstWord(part);
        if (word != wanted && (!isMemberOf(word, wanted) || objects.find(pathInside(around, wanted)))) return std::nullopt;
        around = pathInside(around, word);
    }
    return part;
}

/// Whether what has a name is in a Part, a Repeat or one of its members: "roller_3.rim" is in "roller" and in "roller_3".
bool isNamedInside(const ObjectIndex& objects, std::string_view name, std::string_view part, std::string around = {}) {
    return restInside(objects, name, part, std::move(around)) == std::string_view();
}

bool isMarked(const ObjectIndex& objects, const std::vector<std::string>& marks, std::string_view path) {
    return std::ranges::any_of(marks, [&](const std::string& mark) { return isNamedInside(objects, path, mark); });
}

/// True if the text has syntax errors; missing objects are then no sign of what the author intended.
bool hasBrokenSyntax(const LoadedProject& loaded) {
    const auto& all = loaded.diagnostics.all();
    return std::any_of(all.begin(), all.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error && static_cast<int>(d.code) < 200; });
}

/// Whether an edit changed only what no image shows.
bool isDrawnAlike(const ChangeSet& changes) {
    return changes.isLocal() && !changes.changesProblems() && std::ranges::all_of(changes.parts(), [](const PartChange& part) {
               return part.now->is(Role::Surface) || part.now->is(Role::Log) || part.now->is(Role::Controller);
           });
}

} // namespace

ViewportScene::ViewportScene(Document& document, RunSession& session, RenderService* render, QObject* parent)
    : QObject(parent), m_document(document), m_session(session), m_render(render), m_dragged(render) {
    connect(&m_document, &Document::changed, this, [this](const ChangeSet& changes) {
        m_drawnAlike = m_experiment && changes.before() && changes.before()->experiment == m_experiment && isDrawnAlike(changes);
        updateScene();
        m_drawnAlike = false;
    });
    connect(&m_document.editedModel(), &EditedModel::changed, this, &ViewportScene::updateScene);
    connect(&m_session, &RunSession::experimentChanged, this, &ViewportScene::updateScene);
    connect(&m_session, &RunSession::stateChanged, this, &ViewportScene::updateScene);
    connect(&m_session, &RunSession::advanced, this, &ViewportScene::updatePoses);
    connect(&m_document, &Document::opened, this, [this] {
        const QSignalBlocker quiet(m_joints); // changed() of the document follows
        m_joints.reset();
    });
    connect(&m_joints, &JointPositions::changed, this, [this] {
        if (m_running) return;
        m_poses = posesOfText();
        m_bounds.reset();
        Q_EMIT posed();
    });
    m_objects = std::make_shared<ObjectIndex>(std::make_shared<ExperimentSpec>());
    m_poses = std::make_shared<BodyPoses>();
    updateScene();
}

ViewportScene::~ViewportScene() {
    if (m_render && m_scene != SceneId::None) m_render->removeScene(m_scene);
}

void ViewportScene::updateScene() {
    const bool runs = m_session.results().experiment && m_session.results().poses;
    if (runs && !m_running) {
        const QSignalBlocker quiet(m_joints); // the poses of the run are shown below
        m_joints.reset();
    }
    std::shared_ptr<const ExperimentSpec> experiment = runs ? m_session.results().experiment : m_session.source().shown();
    if (experiment == m_experiment) {
        if (runs == m_running) return updatePoses();
        m_running = runs;
        m_poses = posesOfText();
        m_bounds.reset();
        updatePoses();
        Q_EMIT posed();
        return;
    }
    m_running = runs;
    m_experiment = experiment;
    if (!experiment) experiment = std::make_shared<ExperimentSpec>();
    m_objects = std::make_shared<ObjectIndex>(experiment);
    m_cameras = trundle::camerasOf(*experiment);
    m_rangeSensors = rangeModelsOf(*experiment);
    const std::shared_ptr<const BodyPoses> now = runs ? m_session.results().poses : nullptr;
    m_poses = now && now->size() == m_objects->poseCount() ? now : posesOfText();
    if (m_render && !(m_drawnAlike && m_scene != SceneId::None)) {
        const SceneId before = m_scene;
        m_ghosts = runs ? nullptr : ghosts();
        m_scene = m_render->addScene(experiment, m_ghosts);
        if (before != SceneId::None) m_render->removeScene(before);
    }
    m_dragged.setWorld(m_experiment, m_ghosts);
    listHidden();
    Q_EMIT replaced();
}

std::shared_ptr<const BodyPoses> ViewportScene::posesOfText() const {
    auto poses = std::make_shared<BodyPoses>(startPoses(m_objects->experiment()));
    m_joints.apply(*m_objects, *poses);
    return poses;
}

void ViewportScene::updatePoses() {
    if (!m_running && m_session.results().poses) return updateScene();
    const std::shared_ptr<const BodyPoses> poses = m_running ? m_session.results().poses : nullptr;
    if (!poses || poses == m_poses || poses->size() != m_objects->poseCount()) return;
    m_poses = poses;
    m_bounds.reset();
    Q_EMIT posed();
}

std::shared_ptr<const ExperimentSpec> ViewportScene::ghosts() const {
    const std::shared_ptr<const ExperimentSpec> good = m_document.isOpen() ? m_session.source().lastValid() : nullptr;
    if (!good || !m_document.loaded()->diagnostics.hasErrors()) return nullptr;
    const LoadedProject& now = *m_document.loaded();
    const bool broken = hasBrokenSyntax(now);
    return ghostsOf(*m_experiment, *good, [&](const std::string& path) { return broken || placeOf(now, path).has_value(); });
}

std::vector<ObjectRef> ViewportScene::objectsOf(const std::string& path) const {
    if (const auto object = find(path)) return {*object};
    std::vector<ObjectRef> objects;
    if (path.empty()) return objects; // the experiment
    const auto add = [&](const std::string& instance, std::string_view rest) {
        if (const auto object = find(rest.empty() ? instance : pathInside(instance, rest))) objects.push_back(*object);
        else addInside(instance, rest, objects);
    };
    const std::string_view first = firstWord(path), inside = withoutFirstWord(path);
    const bool isRobotConfig = first == "RobotConfig", isStaticConfig = first == "StaticConfig";
    if (isRobotConfig || isStaticConfig) {
        if (inside.empty()) return objects;
        const std::string_view config = firstWord(inside), rest = withoutFirstWord(inside);
        const ExperimentSpec& e = m_objects->experiment();
        if (isRobotConfig) {
            for (const RobotSpec& robot : e.robots)
                if (robot.config && robot.config->name == config) add(robot.name, rest);
        } else {
            for (const StaticSpec& fixed : e.statics)
                if (fixed.configName == config) add(fixed.name, rest);
        }
        return objects;
    }
    const auto isObject = [&](std::string_view name) { return m_objects->find(name).has_value(); };
    const auto addMeant = [&](const std::string& name) { // the path means it, or what is in it, or the Repeat that it is in
        if (const auto rest = restBehind(path, name, isObject)) add(name, *rest);
        else if (isNamedInside(*m_objects, name, path)) add(name, {});
    };
    for (const RobotSpec& robot : m_objects->experiment().robots)
        if (!robot.scenery) addMeant(robot.name);
    for (const StaticSpec& fixed : m_objects->experiment().statics) addMeant(fixed.name);
    return objects;
}

/// What a Part or Repeat of an instance holds: the bodies or geoms whose names begin with its name.
void ViewportScene::addInside(const std::string& instance, std::string_view part, std::vector<ObjectRef>& objects) const {
    const auto object = find(instance);
    const auto bodies = object ? m_objects->bodiesOf(*object) : std::nullopt;
    const RobotSpec* robot = bodies ? &m_objects->experiment().robots[*bodies] : nullptr;
    const StaticSpec* fixed = object ? m_objects->staticOf(*object) : nullptr;
    if (part.empty()) return;
    for (std::uint32_t i = 0; robot && robot->config && i < robot->config->bodies.size(); ++i) {
        const BodySpec& body = robot->config->bodies[i];
        const std::optional<std::string_view> rest = restInside(*m_objects, body.name, part, instance);
        if (!rest) continue;
        if (rest->empty()) objects.push_back({ObjectKind::Body, *bodies, i});
        for (std::uint32_t k = 0; !rest->empty() && k < body.geoms.size(); ++k)
            if (isNamedInside(*m_objects, body.geoms[k].name, *rest, pathInside(instance, body.name)))
                objects.push_back({ObjectKind::Geom, *bodies, i, k});
    }
    for (std::uint32_t i = 0; fixed && fixed->geoms && i < fixed->geoms->size(); ++i)
        if (isNamedInside(*m_objects, (*fixed->geoms)[i].name, part, instance))
            objects.push_back({ObjectKind::StaticGeom, object->instance, 0, i});
}

const CameraModel* ViewportScene::camera(const std::string& path) const {
    const auto it = std::ranges::find(m_cameras, path, &CameraModel::path);
    return it == m_cameras.end() ? nullptr : &*it;
}

std::vector<const CameraModel*> ViewportScene::camerasOf(const std::string& path) const {
    std::vector<const CameraModel*> found;
    for (const CameraModel& camera : m_cameras)
        if (isPartOf(path, camera.robot, camera.body, camera.path)) found.push_back(&camera);
    return found;
}

bool ViewportScene::isPartOf(const std::string& path, const std::string& robot, std::size_t body,
                             const std::string& component) const {
    if (path.empty()) return false;
    // Splits "seeker.eye" or "RobotConfig.Seeker.eye" into the robot or config and the component.
    const bool byConfig = firstWord(path) == "RobotConfig" || firstWord(path) == "StaticConfig";
    const std::string_view local = byConfig ? withoutFirstWord(path) : path;
    const std::string_view name = firstWord(local);
    const auto object = find(robot);
    const auto bodies = object ? m_objects->bodiesOf(*object) : std::nullopt;
    const RobotSpec* spec = bodies ? &m_objects->experiment().robots[*bodies] : nullptr;
    if (!spec || !spec->config) return false;
    const auto rest = restBehind(path, robot, [&](std::string_view other) { return m_objects->find(other).has_value(); });
    if (byConfig ? spec->config->name != name : !rest && !isNamedInside(*m_objects, robot, path)) return false;
    const std::string_view which = byConfig ? withoutFirstWord(local) : rest.value_or(std::string_view());
    const std::string inRobot = robot + "/";
    if (which.empty() || (component.starts_with(inRobot) && isNameOf(std::string_view(component).substr(inRobot.size()), which)))
        return true;
    const std::size_t own = body - m_objects->firstPose(*bodies);
    return own < spec->config->bodies.size() && isNameOf(spec->config->bodies[own].name, which);
}

bool ViewportScene::holds(const std::vector<std::string>& marks, const ObjectRef& object) const {
    return !marks.empty() && isMarked(*m_objects, marks, m_objects->pathOf(object));
}

JointPositions& jointPositions(ViewportScene& scene) { return scene.m_joints; }

bool isNameOf(std::string_view name, std::string_view path) {
    if (name == path || lastWord(name) != lastWord(path)) return name == path; // `arm_1` may be no member of an arm
    const std::optional<std::string_view> behind = restBehind(path, name);
    return behind && behind->empty();
}

bool isLocked(const ViewportScene& scene, const std::string& path) { return isMarked(*scene.m_objects, scene.m_locked, path); }

bool showsModel(const ViewportScene& scene) { return scene.m_document.editedModel().isOpen(); }

bool ViewportScene::isLocked(const ObjectRef& object) const {
    const StaticSpec* fixed = m_objects->staticOf(object);
    return (fixed && (fixed->configName == kPreviewFloor || fixed->configName == kPreviewRamp)) || holds(m_locked, object);
}

const Bounds& ViewportScene::bounds() const {
    if (m_bounds) return *m_bounds;
    m_bounds.emplace();
    for (const ObjectRef& object : m_objects->instances())
        if (!isHidden(object)) m_bounds->add(boundsOf(object));
    return *m_bounds;
}

std::vector<RayHit> ViewportScene::hitsAlong(const ViewRay& ray, bool alsoLocked) const {
    std::vector<RayHit> hits = castRay(*m_objects, *m_poses, ray);
    if (!m_hidden.empty() || !m_locked.empty())
        std::erase_if(hits, [&](const RayHit& hit) { return isHidden(hit.geom) || (!alsoLocked && isLocked(hit.geom)); });
    return hits;
}

void ViewportScene::setHidden(std::vector<std::string> paths) {
    if (paths == m_hidden) return;
    m_hidden = std::move(paths);
    listHidden();
    Q_EMIT marked();
}

void ViewportScene::setLocked(std::vector<std::string> paths) {
    m_locked = std::move(paths);
    Q_EMIT marked();
}

void ViewportScene::listHidden() {
    m_bounds.reset();
    m_hiddenInScene.clear();
    for (const std::string& path : m_hidden)
        for (const ObjectRef& object : objectsOf(path)) {
            m_hiddenInScene.push_back(m_objects->pathOf(object, '/'));
            const auto moving = object.kind == ObjectKind::Static ? m_objects->bodiesOf(object) : std::nullopt;
            const std::size_t bodies = moving ? m_objects->experiment().robots[*moving].config->bodies.size() : 0;
            for (std::uint32_t i = 0; i < bodies; ++i)
                m_hiddenInScene.push_back(m_objects->pathOf({ObjectKind::Body, *moving, i}, '/'));
        }
}

} // namespace trundle
