#include "check/start_scene.h"

#include <algorithm>

#include "world/engine_links.h"

namespace trundle {

std::optional<StartScene> StartScene::build(const ExperimentSpec& experiment, const std::stop_token& stop) {
    StartScene scene;
    scene.m_experiment = &experiment;
    const SettingsSpec& s = experiment.settings;
    auto engine = makeOdeEngine({s.gravity, s.seed, s.solver, s.iterations, s.errorReduction, experiment.surfaces});
    if (!engine) return std::nullopt;
    scene.m_engine = std::move(engine).value();
    if (!scene.addStatics(stop) || !scene.addRobots(stop) || !scene.addLinks()) return std::nullopt;
    scene.m_engine->findContacts();
    return scene;
}

bool StartScene::addStatics(const std::stop_token& stop) {
    for (std::uint32_t i = 0; i < m_experiment->statics.size(); ++i) {
        if (stop.stop_requested()) return false;
        const StaticSpec& s = m_experiment->statics[i];
        if (!s.geoms) continue;
        for (const GeomSpec& g : *s.geoms) {
            if (!g.collide) continue;
            const auto id = m_engine->addStatic(g, s.pose * g.pose);
            if (!id) return false;
            m_owners.resize(id.value().index + 1);
            m_owners.back() = {true, i, 0, &g};
        }
    }
    return true;
}

bool StartScene::addRobots(const std::stop_token& stop) {
    for (std::uint32_t i = 0; i < m_experiment->robots.size(); ++i) {
        if (stop.stop_requested()) return false;
        const RobotSpec& spec = m_experiment->robots[i];
        ActorDef def{spec.pose, {}, &spec.config->joints, spec.config->selfCollision, nullptr, nullptr, &spec.config->noContact};
        for (const BodySpec& body : spec.config->bodies) def.bodies.push_back({spec.pose * body.pose, &body});
        const auto made = m_engine->addActor(def);
        if (!made) return false;
        m_actors.push_back(made.value().actor);
        m_bodies.push_back(made.value().bodies);
        for (std::uint32_t b = 0; b < spec.config->bodies.size(); ++b)
            for (std::size_t g = 0; g < spec.config->bodies[b].geoms.size(); ++g) {
                const GeomHandle geom = made.value().geoms[b][g];
                if (!geom.valid()) continue;
                m_owners.resize(geom.index + 1);
                m_owners.back() = {false, i, b, &spec.config->bodies[b].geoms[g]};
            }
    }
    return true;
}

/// What is joined, or has no contact, does not overlap.
bool StartScene::addLinks() {
    for (const auto& link : m_experiment->joints) {
        const auto bodyOf = [&](int robot, int body) {
            return robot == kWorldBody ? BodyHandle{} : m_bodies[static_cast<std::size_t>(robot)][static_cast<std::size_t>(body)];
        };
        if (!m_engine->links->addJoint(link.spec, bodyOf(link.childRobot, link.spec.child),
                                       bodyOf(link.parentRobot, link.spec.parent)))
            return false;
    }
    for (const auto& [first, second] : m_experiment->noContact) m_engine->links->separate(m_actors[first], m_actors[second]);
    return true;
}

bool StartScene::isJoined(std::size_t robot, std::size_t body) const {
    const auto is = [&](int r, int b) {
        return r != kWorldBody && static_cast<std::size_t>(r) == robot && static_cast<std::size_t>(b) == body;
    };
    const auto joins = [&](const auto& link) {
        return is(link.parentRobot, link.spec.parent) || is(link.childRobot, link.spec.child);
    };
    return std::ranges::any_of(m_experiment->joints, joins) || std::ranges::any_of(m_experiment->springs, joins);
}

std::string StartScene::pathOf(std::uint32_t geom) const {
    const GeomOwner& o = m_owners[geom];
    if (o.isStatic) return m_experiment->statics[o.object].name + "/" + o.spec->name;
    const RobotSpec& robot = m_experiment->robots[o.object];
    return robot.name + "/" + robot.config->bodies[o.body].name + "/" + o.spec->name;
}

Vec3 StartScene::up() const {
    const Vec3& gravity = m_experiment->settings.gravity;
    return gravity.norm() > 1e-6 ? Vec3(-gravity.normalized()) : Vec3(Vec3::Zero());
}

} // namespace trundle
