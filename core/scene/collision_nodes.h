#pragma once
// What collides, drawn over what is seen (kMaskCollision).

#include "model/experiment_spec.h"
#include "scene/nodes/shape_store.h"
#include "scene/scene_objects.h"

namespace trundle {

class CollisionNodes {
public:
    CollisionNodes(osg::Group& scene, const SceneShading& look);
    /// Once, from the experiment that the objects were made from.
    void make(const ExperimentSpec& experiment, const SceneObjects& objects, ShapeStore& store);
    void followPoses() const { follow(m_followers); }

private:
    osg::ref_ptr<osg::Group> m_collision = new osg::Group;
    std::vector<FollowingNode> m_followers;
};

} // namespace trundle
