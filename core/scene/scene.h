#pragma once
// The OSG scene of one experiment. Built and used on one thread (the render thread). Keeps no pointer into the experiment.

#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>

#include "model/experiment_spec.h"
#include "scene/nodes/masks.h"
#include "scene/nodes/shape_store.h"
#include "scene/overlay.h"
#include "scene/queries/camera_view.h"
#include "scene/queries/poses.h"
#include "scene/scene_marks.h"
#include "scene/shaders/scene_shading.h"
#include "scene/shapes/bounds.h"

namespace trundle {

struct SceneHit {
    std::string path; ///< "robot0/chassis/hull", "arena/north"
    Vec3 point = Vec3::Zero();
    double distance = 0; ///< m from the ray's origin
};

/// Names of the objects in kMaskData images: "robot0/chassis/hull", "arena/north". The first entry means "no object" and is
/// empty.
[[nodiscard]] std::vector<std::string> objectNames(const ExperimentSpec& experiment);

class Scene {
public:
    /// All objects at their start poses. Geoms that cannot be drawn (sizes or positions out of range) are left out; a missing
    /// mesh or height map is a bright marker. `ghosts` are drawn at their start poses under kMaskGhosts and cannot be picked.
    explicit Scene(const ExperimentSpec& experiment, std::shared_ptr<ShapeStore> store = nullptr,
                   const ExperimentSpec* ghosts = nullptr);

    [[nodiscard]] osg::Group& root() { return *m_root; }
    /// Ignored unless there is one pose per robot body; poses that are not finite are skipped.
    void setPoses(const BodyPoses& poses);
    /// Hides objects in all images. Unknown paths are ignored, here and in setMarks().
    void setHidden(const std::vector<std::string>& paths);
    /// Sets what marks() draws: selected objects in pure red, hovered ones in pure green.
    void setMarks(const SceneMarks& marks);
    [[nodiscard]] osg::Group& marks() { return *m_marks; }
    void setWireframe(bool on);
    /// Lines and a checker pattern on floors without a texture; initially on.
    void setFloorLines(bool on) { m_uniforms.floorLines->set(on ? 1.f : 0.f); }
    /// Sets the content of kMaskOverlay. Shapes with unknown body indices are skipped.
    void setOverlay(const SceneOverlay& overlay);
    /// Builds the content of kMaskCollision, once, from the experiment that the scene was made from.
    void makeCollision(const ExperimentSpec& experiment);
    /// Builds the content of kMaskData, once, from the experiment that the scene was made from.
    void makeData(const ExperimentSpec& experiment);
    /// Updates the kMaskData nodes to the current poses; hidden objects are left out.
    void followData();

    /// World bounds for framing: robots at their current poses, and statics, without floors.
    [[nodiscard]] Bounds bounds() const;
    /// The nearest object hit by the ray. `mask` selects robots, statics and floors.
    [[nodiscard]] std::optional<SceneHit> pick(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// All geoms hit by the ray, nearest first, each once.
    [[nodiscard]] std::vector<SceneHit> pickAll(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// World bounding boxes of everything that casts sun shadows; empty if the sun casts none.
    [[nodiscard]] std::vector<Bounds> sunCasters() const;
    [[nodiscard]] const Vec3& sun() const { return m_sun; } ///< unit vector towards the sun
    /// Height of the level floor (m), if there is one.
    [[nodiscard]] std::optional<double> floorHeight() const { return m_floorHeight; }
    [[nodiscard]] const ShapeStore& store() const { return *m_store; }

private:
    struct Object {
        osg::ref_ptr<osg::Group> node;
        osg::ref_ptr<osg::Group> shapes; ///< its geoms; null for a robot, whose bodies hold them, and for a floor
    };
    /// A node that copies the pose of a body's node.
    struct BodyNode {
        osg::ref_ptr<osg::MatrixTransform> node, leader;
    };
    /// The same for kMaskData; visible only while the body's node and the whole object are.
    struct DataBodyNode {
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
    /// The object that owns the geom at that path, and the geom's index in it.
    [[nodiscard]] std::pair<const Object*, std::uint32_t> findGeom(const std::string& path) const;

    std::shared_ptr<ShapeStore> m_store;
    SceneUniforms m_uniforms;
    osg::ref_ptr<osg::Group> m_root = new osg::Group, m_robots = new osg::Group, m_statics = new osg::Group,
                             m_collision = new osg::Group, m_data = new osg::Group, m_marks = new osg::Group,
                             m_overlaidShapes = new osg::Group, m_overlaidFloor = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> m_bodies; // in the order of BodyPoses
    std::unordered_map<std::string, Object> m_objects;        // by path
    std::vector<BodyNode> m_markFollowers, m_collisionFollowers, m_overlayFollowers;
    std::vector<DataBodyNode> m_dataFollowers;
    SceneMarks m_marked;
    SceneOverlay m_overlaid;
    std::vector<std::string> m_hidden;
    bool m_wireframe = false;
    std::optional<double> m_floorHeight;
    Vec3 m_sun = Vec3::UnitZ();
    bool m_sunCasts = false;
    mutable std::unordered_map<const osg::Group*, Bounds> m_boxes; // local bounds of the shapes of objects
};

} // namespace trundle
