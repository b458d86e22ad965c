#include "scene/queries/object_index.h"

namespace trundle {
namespace {

std::size_t endOfWord(std::string_view path, std::size_t begin) { return std::min(path.find_first_of("./", begin), path.size()); }

/// The name of the instance that a path begins with; it may itself be dotted, like the path of its config ("RobotConfig.Rover").
std::string_view instanceOf(std::string_view path) {
    const std::size_t end = endOfWord(path, 0);
    const bool isConfig = path.starts_with("RobotConfig") || path.starts_with("StaticConfig");
    const bool hasMore = end < path.size() && isConfig && end == path.find("Config") + 6;
    return path.substr(0, hasMore ? endOfWord(path, end + 1) : end);
}

/// What has that name, or the name of which the path continues: "left.wheel" of "left.wheel.tyre".
template <class T> std::optional<std::uint32_t> named(const std::vector<T>& parts, std::string_view path, bool isWhole) {
    const auto it = std::find_if(parts.begin(), parts.end(), [&](const T& part) {
        if (!path.starts_with(part.name)) return false;
        const std::size_t size = part.name.size();
        return path.size() == size || (!isWhole && (path[size] == '.' || path[size] == '/'));
    });
    if (it == parts.end()) return std::nullopt;
    return static_cast<std::uint32_t>(it - parts.begin());
}

} // namespace

ObjectIndex::ObjectIndex(std::shared_ptr<const ExperimentSpec> experiment) : m_experiment(std::move(experiment)) {
    const ExperimentSpec& e = *m_experiment;
    m_firstPose.reserve(e.robots.size());
    for (std::uint32_t i = 0; i < e.robots.size(); ++i) {
        m_firstPose.push_back(m_poseCount);
        m_robots.try_emplace(e.robots[i].name, i);
        if (!e.robots[i].config) continue;
        m_poseCount += e.robots[i].config->bodies.size();
        for (const BodySpec& body : e.robots[i].config->bodies) addBalls(body.geoms);
    }
    for (std::uint32_t i = 0; i < e.statics.size(); ++i) {
        m_statics.try_emplace(e.statics[i].name, i);
        if (e.statics[i].geoms) addBalls(*e.statics[i].geoms);
    }
}

void ObjectIndex::addBalls(const std::vector<GeomSpec>& geoms) {
    auto [entry, isNew] = m_balls.try_emplace(&geoms);
    if (!isNew) return;
    for (const GeomSpec& geom : geoms) entry->second.push_back(ballAround(geom));
}

const std::vector<Ball>& ObjectIndex::ballsOf(const std::vector<GeomSpec>& geoms) const {
    static const std::vector<Ball> kNone;
    const auto it = m_balls.find(&geoms);
    return it == m_balls.end() ? kNone : it->second;
}

std::optional<ObjectRef> ObjectIndex::find(std::string_view path) const {
    std::string_view instance = instanceOf(path);
    const auto isNone = [&] { return m_statics.find(instance) == m_statics.end() && m_robots.find(instance) == m_robots.end(); };
    for (std::string_view longer = instance; isNone() && longer.size() < path.size();) { // "row_3.cart" in a Repeat
        longer = path.substr(0, endOfWord(path, longer.size() + 1));
        if (m_statics.find(longer) != m_statics.end() || m_robots.find(longer) != m_robots.end()) instance = longer;
    }
    const std::string_view inside = path.substr(std::min(path.size(), instance.size() + 1));
    if (inside.empty() && instance.size() != path.size()) return std::nullopt; // "robot0."
    if (const auto it = m_statics.find(instance); it != m_statics.end()) {
        if (inside.empty()) return ObjectRef{ObjectKind::Static, it->second};
        const auto& geoms = m_experiment->statics[it->second].geoms;
        if (const auto geom = geoms ? named(*geoms, inside, true) : std::nullopt)
            return ObjectRef{ObjectKind::StaticGeom, it->second, 0, *geom};
    }
    const auto it = m_robots.find(instance);
    if (it == m_robots.end()) return std::nullopt;
    if (inside.empty()) return ObjectRef{ObjectKind::Robot, it->second};
    const auto& config = m_experiment->robots[it->second].config;
    const auto body = config ? named(config->bodies, inside, false) : std::nullopt;
    if (!body) return std::nullopt;
    const std::string& bodyName = config->bodies[*body].name;
    if (inside.size() == bodyName.size()) return ObjectRef{ObjectKind::Body, it->second, *body};
    const auto geom = named(config->bodies[*body].geoms, inside.substr(bodyName.size() + 1), true);
    return geom ? std::optional(ObjectRef{ObjectKind::Geom, it->second, *body, *geom}) : std::nullopt;
}

const RobotSpec* ObjectIndex::robotOf(const ObjectRef& object) const {
    return object.kind <= ObjectKind::Geom ? &m_experiment->robots[object.instance] : nullptr;
}

const StaticSpec* ObjectIndex::staticOf(const ObjectRef& object) const {
    return object.kind > ObjectKind::Geom ? &m_experiment->statics[object.instance] : nullptr;
}

std::optional<std::uint32_t> ObjectIndex::bodiesOf(const ObjectRef& object) const {
    if (robotOf(object)) return object.instance;
    const auto it = m_robots.find(staticOf(object)->name);
    return it == m_robots.end() ? std::nullopt : std::optional(it->second);
}

const GeomSpec* ObjectIndex::geomOf(const ObjectRef& object) const {
    if (object.kind == ObjectKind::Geom) return &robotOf(object)->config->bodies[object.body].geoms[object.geom];
    if (object.kind == ObjectKind::StaticGeom) return &(*staticOf(object)->geoms)[object.geom];
    return nullptr;
}

std::string ObjectIndex::pathOf(const ObjectRef& object, char separator) const {
    const RobotSpec* robot = robotOf(object);
    std::string path = robot ? robot->name : staticOf(object)->name;
    if (object.kind == ObjectKind::Body || object.kind == ObjectKind::Geom)
        path += separator + robot->config->bodies[object.body].name;
    if (const GeomSpec* geom = geomOf(object)) path += separator + geom->name;
    return path;
}

std::optional<ObjectRef> ObjectIndex::ownerOf(const ObjectRef& object) const {
    switch (object.kind) {
    case ObjectKind::Body: {
        const RobotSpec& robot = m_experiment->robots[object.instance];
        const auto fixed = robot.scenery ? m_statics.find(robot.name) : m_statics.end();
        return fixed == m_statics.end() ? ObjectRef{ObjectKind::Robot, object.instance}
                                        : ObjectRef{ObjectKind::Static, fixed->second};
    }
    case ObjectKind::Geom: return ObjectRef{ObjectKind::Body, object.instance, object.body};
    case ObjectKind::StaticGeom: return ObjectRef{ObjectKind::Static, object.instance};
    default: return std::nullopt;
    }
}

std::vector<ObjectRef> ObjectIndex::instances() const {
    std::vector<ObjectRef> all;
    for (std::uint32_t i = 0; i < m_experiment->robots.size(); ++i)
        if (!m_experiment->robots[i].scenery) all.push_back({ObjectKind::Robot, i});
    for (std::uint32_t i = 0; i < m_experiment->statics.size(); ++i) all.push_back({ObjectKind::Static, i});
    return all;
}

Pose ObjectIndex::poseOf(const ObjectRef& object, const BodyPoses& poses) const {
    if (const StaticSpec* fixed = staticOf(object)) {
        const GeomSpec* geom = geomOf(object);
        return geom ? fixed->pose * geom->pose : fixed->pose;
    }
    const RobotSpec& robot = *robotOf(object);
    const std::size_t first = m_firstPose[object.instance];
    const bool posed = robot.config && !robot.config->bodies.empty() && poses.size() == m_poseCount;
    if (object.kind == ObjectKind::Robot) return posed ? poses[first] * robot.config->bodies[0].pose.inverse() : robot.pose;
    const BodySpec& body = robot.config->bodies[object.body];
    const Pose at = posed ? poses[first + object.body] : robot.pose * body.pose;
    return object.kind == ObjectKind::Geom ? at * body.geoms[object.geom].pose : at;
}

Pose ObjectIndex::frameOf(const ObjectRef& object, const BodyPoses& poses) const {
    const auto owner = ownerOf(object);
    return owner ? poseOf(*owner, poses) : Pose{};
}

Bounds ObjectIndex::boundsOf(const ObjectRef& object, const BodyPoses& poses) const {
    Bounds all;
    const auto addGeoms = [&](const std::vector<GeomSpec>& geoms, const Pose& pose) {
        for (const GeomSpec& geom : geoms)
            if (geom.visible) all.add(trundle::boundsOf(geom, pose));
    };
    if (const GeomSpec* geom = geomOf(object)) return trundle::boundsOf(*geom, frameOf(object, poses));
    if (const StaticSpec* fixed = staticOf(object)) {
        if (fixed->geoms) addGeoms(*fixed->geoms, fixed->pose);
    }
    const std::optional<std::uint32_t> bodies = bodiesOf(object);
    const RobotConfigSpec* const config = bodies ? m_experiment->robots[*bodies].config.get() : nullptr;
    for (std::uint32_t i = 0; config && i < config->bodies.size(); ++i) {
        if (object.kind == ObjectKind::Body && i != object.body) continue;
        addGeoms(config->bodies[i].geoms, poseOf({ObjectKind::Body, *bodies, i}, poses));
    }
    return all;
}

} // namespace trundle
