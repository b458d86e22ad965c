#include "world/world_radio.h"

#include "world/rays/ray_targets.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kMaxSolids = 64;
constexpr double kPast = 1e-4; ///< m behind a surface, where the ray continues

} // namespace

WorldRadio::WorldRadio(const ExperimentSpec& experiment, const Engine& engine, const WorldObjects& objects)
    : m_engine(engine), m_objects(objects), m_medium(experiment.medium) {
    m_medium.setWalls(
        [this](RadioId first, const Vec3& a, RadioId second, const Vec3& b) { return solids(first, a, second, b); });
    for (const RobotSpec& robot : experiment.robots)
        for (const ComponentSpec& device : robot.config->devices)
            if (device.kind == "Transceiver") m_medium.reserve(static_cast<std::uint32_t>(device.number("Address")));
}

RadioId WorldRadio::open(RadioDefinition definition, const RadioMount& mount) {
    const RadioId id = m_medium.open(std::move(definition));
    m_mounts.resize(id + 1);
    m_mounts[id] = mount;
    return id;
}

void WorldRadio::place() {
    for (RadioId id = 0; id < m_mounts.size(); ++id) {
        const BodyState& s = m_engine.state({m_mounts[id].body});
        m_medium.place(id, Pose{s.position, s.rotation} * m_mounts[id].mount);
    }
}

void WorldRadio::switchOff(std::uint32_t robot) {
    for (RadioId id = 0; id < m_mounts.size(); ++id)
        if (m_mounts[id].robot == robot) m_medium.switchOff(id);
}

void WorldRadio::advance(double until) {
    if (!m_mounts.empty()) m_medium.advance(std::llround(until * 1e6));
}

/// Number of solids between two radios, each counted once, without those of their own robots.
int WorldRadio::solids(RadioId first, const Vec3& a, RadioId second, const Vec3& b) const {
    const Vec3 way = b - a;
    const double length = way.norm();
    if (length < kPast) return 0;
    const Vec3 direction = way / length;
    const BuiltRobot &sender = m_objects.robots()[m_mounts[first].robot], &receiver = m_objects.robots()[m_mounts[second].robot];
    const std::string own[2] = {sender.spec->name + "/", receiver.spec->name + "/"};
    std::vector<std::uint32_t> met;
    double gone = 0;
    for (int i = 0; i < kMaxSolids && gone < length; ++i) {
        const auto hit = m_engine.rays().ray({a + gone * direction, direction, length - gone}, sender.handles.actor.index);
        if (!hit) break;
        gone += hit->distance + kPast;
        const std::string& path = m_objects.geomPath(hit->geom);
        const bool isOwn = path.starts_with(own[0]) || path.starts_with(own[1]);
        if (!isOwn && std::find(met.begin(), met.end(), hit->geom) == met.end()) met.push_back(hit->geom);
    }
    return static_cast<int>(met.size());
}

} // namespace trundle
