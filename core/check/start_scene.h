#pragma once
// All shapes of an experiment at their start poses, in the physics engine: contacts and ray queries for the checks.

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "model/experiment_spec.h"
#include "world/engine.h"
#include "world/rays/ray_targets.h"

namespace trundle {

/// Owner of an engine geom: a robot's body or a Static.
struct GeomOwner {
    bool isStatic = false;
    std::uint32_t object = 0; ///< index of the robot or static in the experiment
    std::uint32_t body = 0;   ///< index in the robot's config
    const GeomSpec* spec = nullptr;
};

class StartScene {
public:
    /// Nothing if a shape cannot be built or a stop is requested. The experiment must be buildable and must outlive the scene.
    [[nodiscard]] static std::optional<StartScene> build(const ExperimentSpec& experiment, const std::stop_token& stop);

    [[nodiscard]] const ExperimentSpec& experiment() const { return *m_experiment; }
    [[nodiscard]] std::size_t contactCount() const { return m_engine->contactCount(); }
    [[nodiscard]] EngineContact contact(std::size_t index) const { return m_engine->contact(index); }
    [[nodiscard]] std::uint32_t geomCount() const { return static_cast<std::uint32_t>(m_owners.size()); }
    [[nodiscard]] const GeomOwner& owner(std::uint32_t geom) const { return m_owners[geom]; }
    /// Nearest hit along a ray, ignoring one robot.
    [[nodiscard]] std::optional<SingleHit> ray(const Vec3& origin, const Vec3& direction, double range,
                                               std::size_t withoutRobot) const {
        return m_engine->rays().ray({origin, direction, range}, m_actors[withoutRobot].index);
    }
    /// Path of a geom, such as "robot0/chassis/hull" or "arena/north".
    [[nodiscard]] std::string pathOf(std::uint32_t geom) const;
    /// Whether a joint or spring at the top level holds a body of a robot.
    [[nodiscard]] bool isJoined(std::size_t robot, std::size_t body) const;
    /// Unit vector against gravity; zero without gravity.
    [[nodiscard]] Vec3 up() const;

private:
    [[nodiscard]] bool addStatics(const std::stop_token& stop);
    [[nodiscard]] bool addRobots(const std::stop_token& stop);
    [[nodiscard]] bool addLinks();

    const ExperimentSpec* m_experiment = nullptr;
    std::unique_ptr<Engine> m_engine;
    std::vector<GeomOwner> m_owners;   ///< by engine geom index
    std::vector<ActorHandle> m_actors; ///< by robot index
    std::vector<std::vector<BodyHandle>> m_bodies;
};

} // namespace trundle
