#pragma once
// The OSG scene of one experiment. Built and used on one thread (render's). Nothing in it points into the experiment.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <osg/Group>
#include <osg/MatrixTransform>

#include "model/experiment_spec.h"
#include "scene/bounds.h"
#include "scene/look.h"
#include "scene/masks.h"
#include "scene/poses.h"
#include "scene/view.h"

namespace trundle {

struct SceneHit {
    std::string path; ///< "robot0/chassis/hull", "arena/north"
    Vec3 point = Vec3::Zero();
    double distance = 0; ///< m from the start of the ray
};

class Scene {
public:
    /// Everything at its start pose. Geoms that cannot be drawn (sizes or places beyond all reason) are left out; a missing
    /// mesh or height map is a bright marker.
    explicit Scene(const ExperimentSpec& experiment);

    [[nodiscard]] osg::Group& root() { return *m_root; }
    /// As many as the experiment has robot bodies, else nothing happens; poses that are not finite change nothing.
    void setPoses(const BodyPoses& poses);
    /// What is worth framing: robots where they are now and statics, without floors.
    [[nodiscard]] Bounds bounds() const;
    /// The nearest thing that a ray from a view meets. `mask` of robots, statics, floor.
    [[nodiscard]] std::optional<SceneHit> pick(const ViewRay& ray, std::uint32_t mask = kMaskRobots | kMaskStatics) const;
    /// Height of the level floor, where there is one.
    [[nodiscard]] std::optional<double> floorHeight() const { return m_floorHeight; }
    /// Distinct sets of geoms that were turned into triangles, however many robots share them.
    [[nodiscard]] std::size_t sharedNodes() const { return m_sharedNodes; }

private:
    void addRobots(const ExperimentSpec& experiment);
    void addStatics(const ExperimentSpec& experiment);
    void addSurroundings(const ExperimentSpec& experiment);

    Look m_look;
    osg::ref_ptr<osg::Group> m_root = new osg::Group, m_robots = new osg::Group, m_statics = new osg::Group;
    std::vector<osg::ref_ptr<osg::MatrixTransform>> m_bodies; // in the order of BodyPoses
    std::optional<double> m_floorHeight;
    std::size_t m_sharedNodes = 0;
};

} // namespace trundle
