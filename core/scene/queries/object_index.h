#pragma once
// Index of an experiment's objects by path, with their poses and bounds. Computed from the model and the body poses only, so it
// can be queried on any thread.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "model/experiment_spec.h"
#include "scene/queries/poses.h"
#include "scene/shapes/bounds.h"
#include "scene/shapes/extents.h"

namespace trundle {

enum class ObjectKind : std::uint8_t { Robot, Body, Geom, Static, StaticGeom };

/// Reference to one object of an ObjectIndex.
struct ObjectRef {
    ObjectKind kind = ObjectKind::Robot;
    std::uint32_t instance = 0; ///< index of its robot or static
    std::uint32_t body = 0, geom = 0;
    auto operator<=>(const ObjectRef&) const = default;
};

/// Immutable. Owns a reference to its experiment.
class ObjectIndex {
public:
    explicit ObjectIndex(std::shared_ptr<const ExperimentSpec> experiment);

    [[nodiscard]] const ExperimentSpec& experiment() const { return *m_experiment; }
    /// "robot0", "robot0.chassis.hull" or "robot0/chassis/hull", "arena.north".
    [[nodiscard]] std::optional<ObjectRef> find(std::string_view path) const;
    [[nodiscard]] std::string pathOf(const ObjectRef& object, char separator = '.') const;
    /// The robot, body or static that contains it; nullopt for robots and statics.
    [[nodiscard]] std::optional<ObjectRef> ownerOf(const ObjectRef& object) const;
    /// The robot or static that it is or is in.
    [[nodiscard]] ObjectRef wholeOf(ObjectRef object) const {
        while (const auto owner = ownerOf(object)) object = *owner;
        return object;
    }
    /// All robots in order, then all statics, with what moves in them.
    [[nodiscard]] std::vector<ObjectRef> instances() const;

    /// Pose in the world. A robot's pose is that of its config frame, which is attached to its first body.
    [[nodiscard]] Pose poseOf(const ObjectRef& object, const BodyPoses& poses) const;
    /// World pose of the frame in which the object's Pos and HPR are written.
    [[nodiscard]] Pose frameOf(const ObjectRef& object, const BodyPoses& poses) const;
    /// World bounds of all its visible geoms; empty if there are none, as for a floor.
    [[nodiscard]] Bounds boundsOf(const ObjectRef& object, const BodyPoses& poses) const;

    [[nodiscard]] const GeomSpec* geomOf(const ObjectRef& object) const; ///< nullptr unless it is a Geom or StaticGeom
    [[nodiscard]] const RobotSpec* robotOf(const ObjectRef& object) const;
    [[nodiscard]] const StaticSpec* staticOf(const ObjectRef& object) const;
    /// Index of the robot that has its bodies; of a static that of what moves in it, nullopt if nothing does.
    [[nodiscard]] std::optional<std::uint32_t> bodiesOf(const ObjectRef& object) const;
    [[nodiscard]] std::size_t firstPose(std::size_t robot) const { return m_firstPose[robot]; }
    [[nodiscard]] std::size_t poseCount() const { return m_poseCount; }
    /// Bounding spheres of a set of geoms of this experiment, in the same order.
    [[nodiscard]] const std::vector<Ball>& ballsOf(const std::vector<GeomSpec>& geoms) const;

private:
    void addBalls(const std::vector<GeomSpec>& geoms);

    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::unordered_map<std::string_view, std::uint32_t> m_robots, m_statics;
    std::unordered_map<const std::vector<GeomSpec>*, std::vector<Ball>> m_balls;
    std::vector<std::size_t> m_firstPose;
    std::size_t m_poseCount = 0;
};

} // namespace trundle
