#pragma once
// The OSG scene of one experiment. Built and used on one thread (the render thread). Keeps no pointer into the experiment.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>

#include "scene/collision_nodes.h"
#include "scene/data_nodes.h"
#include "scene/led_lights.h"
#include "scene/led_nodes.h"
#include "scene/mark_nodes.h"
#include "scene/nodes/masks.h"
#include "scene/overlay_nodes.h"
#include "scene/pen_nodes.h"
#include "scene/queries/poses.h"
#include "scene/scene_picking.h"
#include "scene/sun_casters.h"

namespace trundle {

class Scene {
public:
    /// All objects at their start poses. Geoms that cannot be drawn (sizes or positions out of range) are left out; a missing
    /// mesh or height map is a bright marker. `ghosts` are drawn at their start poses under kMaskGhosts and cannot be picked.
    explicit Scene(const ExperimentSpec& experiment, std::shared_ptr<ShapeStore> store = nullptr,
                   const ExperimentSpec* ghosts = nullptr);

    [[nodiscard]] osg::Group& root() { return *m_root; }
    /// Also the colours of Leds. Ignored unless there is one pose per robot body; poses that are not finite are skipped.
    void setPoses(const BodyPoses& poses);
    /// Before a picture from `eye` (world frame, m) is drawn: chooses the Leds that light it.
    void lightLeds(const Vec3& eye) { m_isLedLit = m_ledLights.apply(eye, *m_root->getOrCreateStateSet()); }
    /// True if floors, statics and sky can be drawn before all else.
    [[nodiscard]] bool hasBackground() const { return !m_hasClearStatics; }
    /// True if they look as they looked at the start.
    [[nodiscard]] bool isBackgroundStill() const { return !m_isLedLit && (!m_lines || m_lines->empty()); }
    /// Hides objects in all images. Unknown paths are ignored, here and in setMarks().
    void setHidden(const std::vector<std::string>& paths) { m_objects.setHidden(paths); }
    /// Sets what marks() draws: selected objects in pure red, hovered ones in pure green.
    void setMarks(const SceneMarks& marks) { m_marks.set(marks, m_objects, m_store->look, m_uniforms); }
    [[nodiscard]] osg::Group& marks() { return m_marks.root(); }
    void setWireframe(bool on);
    /// Lines and a checker pattern on floors without a texture; initially on.
    void setFloorLines(bool on) { m_uniforms.floorLines->set(on ? 1.f : 0.f); }
    /// Sets the content of kMaskOverlay. Shapes with unknown body indices are skipped.
    void setOverlay(const SceneOverlay& overlay) { m_overlay.set(overlay, m_bodies, m_floorHeight.value_or(0), m_store->look); }
    /// Builds the content of kMaskCollision, once, from the experiment that the scene was made from.
    void makeCollision(const ExperimentSpec& experiment) { m_collision.make(experiment, m_objects, *m_store); }
    /// Builds the content of kMaskData, once, from the experiment that the scene was made from.
    void makeData(const ExperimentSpec& experiment) { m_data.make(experiment, m_objects, m_store->look); }
    /// Updates the kMaskData nodes to the current poses; hidden objects are left out.
    void followData() { m_data.followObjects(); }

    /// World bounds for framing: robots at their current poses, and statics, without floors.
    [[nodiscard]] Bounds bounds() const;
    /// The nearest object hit by the ray. `mask` selects robots, statics and floors.
    [[nodiscard]] std::optional<SceneHit> pick(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// All geoms hit by the ray, nearest first, each once.
    [[nodiscard]] std::vector<SceneHit> pickAll(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const {
        return trundle::pickAll(*m_root, ray, mask);
    }
    /// World bounding boxes of everything that casts sun shadows; empty if the sun casts none.
    [[nodiscard]] std::vector<Bounds> sunCasters() const {
        return m_sunCasts ? m_casters.boxes(m_objects) : std::vector<Bounds>();
    }
    [[nodiscard]] const Vec3& sun() const { return m_sun; } ///< unit vector towards the sun
    /// Height of the level floor (m), if there is one.
    [[nodiscard]] std::optional<double> floorHeight() const { return m_floorHeight; }
    [[nodiscard]] const ShapeStore& store() const { return *m_store; }

private:
    [[nodiscard]] static osg::ref_ptr<osg::Group> addedGroup(osg::Group& root);
    void addRobots(const ExperimentSpec& experiment);
    void addStatics(const ExperimentSpec& experiment);
    void addGhosts(const ExperimentSpec& ghosts);
    void addSurroundings(const ExperimentSpec& experiment);

    std::shared_ptr<ShapeStore> m_store;
    SceneUniforms m_uniforms;
    osg::ref_ptr<osg::Group> m_root = new osg::Group, m_robots = addedGroup(*m_root), m_statics = addedGroup(*m_root);
    std::vector<osg::ref_ptr<osg::MatrixTransform>> m_bodies; // in the order of BodyPoses
    LedNodes m_leds;
    LedLights m_ledLights;
    SceneObjects m_objects;
    MarkNodes m_marks;
    PenNodes m_pens{*m_root};
    std::shared_ptr<const std::vector<PenLine>> m_lines; // that are drawn
    CollisionNodes m_collision;
    DataNodes m_data;
    OverlayNodes m_overlay;
    mutable SunCasters m_casters;
    bool m_wireframe = false, m_isLedLit = false, m_hasClearStatics = false;
    std::optional<double> m_floorHeight;
    Vec3 m_sun = Vec3::UnitZ();
    bool m_sunCasts = false;
};

} // namespace trundle
