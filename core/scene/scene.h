#pragma once
// The OSG scene of one experiment. Built and used on one thread (render's). Nothing in it points into the experiment.

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>

#include "model/experiment_spec.h"
#include "scene/bounds.h"
#include "scene/look.h"
#include "scene/masks.h"
#include "scene/overlay.h"
#include "scene/poses.h"
#include "scene/scene_marks.h"
#include "scene/shape_store.h"
#include "scene/view.h"

namespace trundle {

struct SceneHit {
    std::string path; ///< "robot0/chassis/hull", "arena/north"
    Vec3 point = Vec3::Zero();
    double distance = 0; ///< m from the start of the ray
};

/// Names of the objects in kMaskData pictures, "robot0/chassis/hull" and "arena/north"; the first, which is nothing, is empty.
[[nodiscard]] std::vector<std::string> objectNames(const ExperimentSpec& experiment);

class Scene {
public:
    /// Everything at its start pose. Geoms that cannot be drawn (sizes or places beyond all reason) are left out; a missing
    /// mesh or height map is a bright marker. `ghosts` are drawn at their start poses, under kMaskGhosts, and not picked.
    explicit Scene(const ExperimentSpec& experiment, std::shared_ptr<ShapeStore> store = nullptr,
                   const ExperimentSpec* ghosts = nullptr);

    [[nodiscard]] osg::Group& root() { return *m_root; }
    /// As many as the experiment has robot bodies, else nothing happens; poses that are not finite change nothing.
    void setPoses(const BodyPoses& poses);
    /// Leaves objects out of all pictures. Paths that name nothing are passed over, here and in setMarks.
    void setHidden(const std::vector<std::string>& paths);
    /// What marks() shows: selected objects in pure red, hovered ones in pure green.
    void setMarks(const SceneMarks& marks);
    [[nodiscard]] osg::Group& marks() { return *m_marks; }
    void setWireframe(bool on);
    /// Lines and a checker pattern on floors without a picture; on at first.
    void setFloorLines(bool on) { m_uniforms.floorLines->set(on ? 1.f : 0.f); }
    /// What kMaskOverlay shows. Shapes in bodies that there are not are passed over.
    void setOverlay(const SceneOverlay& overlay);
    /// Makes what kMaskCollision shows, once. The experiment is the one that the scene was made from.
    void makeCollision(const ExperimentSpec& experiment);
    /// Makes what kMaskData shows, once, of the same experiment.
    void makeData(const ExperimentSpec& experiment);
    /// Puts that where everything stands now; hidden objects are left out.
    void followData();

    /// What is worth framing: robots where they are now and statics, without floors.
    [[nodiscard]] Bounds bounds() const;
    /// The nearest thing that a ray from a view meets. `mask` of robots, statics, floor.
    [[nodiscard]] std::optional<SceneHit> pick(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// Everything along the ray, nearest first, each geom once.
    [[nodiscard]] std::vector<SceneHit> pickAll(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// Boxes in the world around what the sun shines on; none where it casts no shadows.
    [[nodiscard]] std::vector<Bounds> sunCasters() const;
    [[nodiscard]] const Vec3& sun() const { return m_sun; } ///< towards it, unit
    /// Height of the level floor, where there is one.
    [[nodiscard]] std::optional<double> floorHeight() const { return m_floorHeight; }
    [[nodiscard]] const ShapeStore& store() const { return *m_store; }

private:
    struct Object {
        osg::ref_ptr<osg::Group> node;
        osg::ref_ptr<osg::Group> shapes; ///< its geoms; null for a robot, whose bodies have them, and for a floor
    };
    /// A node that stands where a body stands.
    struct Follower {
        osg::ref_ptr<osg::MatrixTransform> node, leader;
    };
    /// The same, shown only where the node and the object it is part of are.
    struct DataFollower {
        osg::ref_ptr<osg::MatrixTransform> node, leader;
        osg::ref_ptr<osg::Group> whole;
    };
    [[nodiscard]] osg::ref_ptr<osg::MatrixTransform> addDataNode(osg::Node& shapes, unsigned firstObject);
    void addRobots(const ExperimentSpec& experiment);
    void addStatics(const ExperimentSpec& experiment);
    void addGhosts(const ExperimentSpec& ghosts);
    void addSurroundings(const ExperimentSpec& experiment);
    void mark(osg::Group& group, const std::string& path);
    [[nodiscard]] const Object* find(const std::string& path) const;
    /// The object that a geom's path begins with, and the geom's number in it.
    [[nodiscard]] std::pair<const Object*, std::uint32_t> findGeom(const std::string& path) const;

    std::shared_ptr<ShapeStore> m_store;
    SceneUniforms m_uniforms;
    osg::ref_ptr<osg::Group> m_root = new osg::Group, m_robots = new osg::Group, m_statics = new osg::Group,
                             m_collision = new osg::Group, m_data = new osg::Group, m_marks = new osg::Group,
                             m_overlaidShapes = new osg::Group, m_overlaidFloor = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> m_bodies; // in the order of BodyPoses
    std::unordered_map<std::string, Object> m_objects;        // by path
    std::vector<Follower> m_markFollowers, m_collisionFollowers, m_overlayFollowers;
    std::vector<DataFollower> m_dataFollowers;
    SceneMarks m_marked;
    SceneOverlay m_overlaid;
    std::vector<std::string> m_hidden;
    bool m_wireframe = false;
    std::optional<double> m_floorHeight;
    Vec3 m_sun = Vec3::UnitZ();
    bool m_sunCasts = false;
    mutable std::unordered_map<const osg::Group*, Bounds> m_boxes; // around the shapes of objects, in their own frames
};

} // namespace trundle
