#include "check/start_scene.h"

namespace trundle {

std::optional<StartScene> StartScene::build(const ExperimentSpec& experiment, const std::stop_token& stop) {
    StartScene scene;
    scene.m_experiment = &experiment;
    const SettingsSpec& s = experiment.settings;
    auto engine = makeOdeEngine({s.gravity, s.seed, s.solver, s.iterations, s.errorReduction, experiment.surfaces});
    if (!engine) return std::nullopt;
    scene.m_engine = std::move(engine).value();
    if (!scene.addStatics(stop) || !scene.addRobots(stop)) return std::nullopt;
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
        ActorDef def{spec.pose, {}, &spec.config->joints, spec.config->selfCollision};
        for (const BodySpec& body : spec.config->bodies) def.bodies.push_back({spec.pose * body.pose, &body});
        const auto made = m_engine->addActor(def);
        if (!made) return false;
        m_actors.push_back(made.value().actor);
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
