#pragma once
// The scenery and robots of an experiment in the engine, and what its handles stand for.

#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <trundle/abi_light.h>

#include "base/diagnostic.h"
#include "world/engine.h"
#include "world/floor_marks.h"
#include "world/signal_plan.h"

namespace trundle {

/// A robot in the engine.
struct BuiltRobot {
    const RobotSpec* spec = nullptr;
    ActorHandles handles;
    Pose frameInFirst;          ///< pose of the config frame in the first body's frame
    bool frameIsFirst = false;  ///< frameInFirst is the identity
    std::optional<Vec3> centre; ///< of a passive object: centre of mass of its first body in the config frame
    std::vector<GeomHandle>
        scenery; ///< of a Static that moves: its fixed geoms, in their order; invalid where one does not collide

    [[nodiscard]] bool isFixed(std::size_t body) const { return spec->config->bodies[body].isFixed; }
};

/// A geom that collides.
struct BuiltGeom {
    std::string path;
    const GeomSpec* spec = nullptr; ///< of the experiment, which outlives it; nullptr: none
    std::uint32_t body = kNoBody;
    Pose pose;                                    ///< in its body, of scenery in the world
    std::uint32_t object = 0;                     ///< its number in objectNames() of the experiment
    Vec3 low = Vec3::Zero(), size = Vec3::Zero(); ///< of its bounding box, if its material has a picture
    static constexpr std::uint32_t kNoBody = 0xffffffffu;
};

/// Anchor and axis of a joint in its parent's frame.
struct JointLocation {
    std::uint32_t parent = 0; ///< engine body; valid only if `carried`
    bool carried = false;     ///< false: attached to the world; anchor and axis are in world coordinates
    Vec3 anchor = Vec3::Zero(), axis = Vec3::UnitZ();
};

class WorldObjects {
public:
    /// Adds everything to the engine, at its start pose. What cannot be built is reported, and then this is of no use.
    void build(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics);

    [[nodiscard]] const std::vector<BuiltRobot>& robots() const { return m_robots; } ///< in the order of the experiment
    /// Joints and springs at the top level, in the order of the experiment.
    [[nodiscard]] const std::vector<JointHandle>& joints() const { return m_joints; }
    [[nodiscard]] const std::vector<CouplingHandle>& springs() const { return m_springs; }
    /// What holds a robot to the world from inside of its config moves along with it.
    void moveWorldJoints(const BuiltRobot& robot, const Pose& motion);
    /// Pose in the world of a robot's config frame; before the first tick exactly the pose of the text, bit for bit.
    [[nodiscard]] static Pose framePose(const BuiltRobot& robot, const Engine& engine, std::uint64_t ticks);
    /// See World::reportedPose.
    [[nodiscard]] static Pose reportedPose(const BuiltRobot& robot, const Engine& engine, std::uint64_t ticks);
    /// The robot of a body, and the body's index in it.
    [[nodiscard]] std::pair<const BuiltRobot*, std::size_t> ownerOf(BodyHandle body) const;
    /// Whether a body is the frame of a Static, which nothing moves.
    [[nodiscard]] bool isFixed(std::uint32_t body) const { return body < m_isFixed.size() && m_isFixed[body]; }

    // By index in the engine.
    [[nodiscard]] bool isBody(std::uint32_t body) const { return body < m_bodyPaths.size(); }
    [[nodiscard]] bool isGeom(std::uint32_t geom) const { return geom < m_geoms.size(); }
    /// False also for a joint without a position.
    [[nodiscard]] bool jointHasPosition(std::uint32_t joint) const {
        return joint < m_jointTypes.size() && hasPosition(m_jointTypes[joint]);
    }
    [[nodiscard]] bool jointHasTwo(std::uint32_t joint) const {
        return joint < m_jointTypes.size() && m_jointTypes[joint] == JointType::Universal;
    }
    [[nodiscard]] const BuiltGeom& geom(std::uint32_t index) const { return m_geoms[index]; }
    /// Its number in objectNames() of the experiment.
    [[nodiscard]] std::uint32_t objectNumber(std::uint32_t geom) const { return m_geoms[geom].object; }
    [[nodiscard]] const std::string& geomPath(std::uint32_t geom) const { return m_geoms[geom].path; }
    [[nodiscard]] std::uint32_t geomMaterial(std::uint32_t geom) const {
        return m_geoms[geom].spec ? m_geoms[geom].spec->material : 0;
    }
    /// Of a material by its index in the experiment, 0..1; 0 if there is none.
    [[nodiscard]] double reflectance(std::uint32_t material) const {
        return material < m_reflectances.size() ? m_reflectances[material] : 0;
    }
    [[nodiscard]] const FloorMarks& marks() const { return m_marks; }
    [[nodiscard]] const std::vector<TrundleLight>& lights() const { return m_lights; }
    [[nodiscard]] const std::vector<std::string>& bodyPaths() const { return m_bodyPaths; }
    [[nodiscard]] SourceRange bodyRange(std::uint32_t body) const { return m_bodyRanges[body]; }
    /// nullptr: no such joint.
    [[nodiscard]] const JointLocation* jointLocation(std::uint32_t joint) const {
        return joint < m_jointLocations.size() ? &m_jointLocations[joint] : nullptr;
    }

    // nullptr: unknown name.
    [[nodiscard]] const std::uint32_t* findBody(const std::string& path) const;
    [[nodiscard]] const BuiltRobot* findRobot(const std::string& name) const;

private:
    void buildScenery(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics);
    void buildRobots(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics);
    void buildLinks(const ExperimentSpec& experiment, Engine& engine, Diagnostics& diagnostics);
    void addGeom(std::uint32_t index, BuiltGeom geom);
    void nameBodies(const BuiltRobot& robot, std::uint32_t firstObject);
    void locateJoints(const BuiltRobot& robot);
    void locate(JointHandle joint, JointType type, const JointLocation& location);

    std::vector<BuiltRobot> m_robots;
    std::vector<JointHandle> m_joints;
    std::vector<CouplingHandle> m_springs;
    std::vector<BuiltGeom> m_geoms;
    std::vector<std::string> m_bodyPaths;
    std::vector<double> m_reflectances; ///< by material
    FloorMarks m_marks;
    std::vector<TrundleLight> m_lights;
    std::vector<std::uint8_t> m_hasPicture; ///< by material
    std::vector<SourceRange> m_bodyRanges;
    std::vector<std::uint8_t> m_isFixed; ///< by body
    std::vector<JointType> m_jointTypes;
    std::vector<JointLocation> m_jointLocations;
    std::unordered_map<std::string, std::uint32_t> m_bodyByPath, m_robotByName; // for lookup only, never iterated
};

} // namespace trundle
