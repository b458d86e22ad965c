#pragma once
// Nodes for depth and segmentation images (kMaskData): a second node per body and static, with the number of its first geom.

#include "model/experiment_spec.h"
#include "scene/scene_objects.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

class DataNodes {
public:
    explicit DataNodes(osg::Group& scene);
    /// Once, from the experiment that the objects were made from.
    void make(const ExperimentSpec& experiment, const SceneObjects& objects, const SceneShading& look);
    /// Takes poses from the objects; hidden objects are left out.
    void followObjects() const;

private:
    /// Visible only while the body's node and the whole object are.
    struct BodyNode {
        osg::ref_ptr<osg::MatrixTransform> node, leader;
        osg::ref_ptr<osg::Group> whole;
    };
    void addStatic(const StaticSpec& fixed, unsigned firstObject, const SceneObjects& objects);
    void add(const SceneObject* object, const SceneObject* whole, unsigned firstObject);
    [[nodiscard]] osg::ref_ptr<osg::MatrixTransform> addNode(osg::Node& shapes, unsigned firstObject);

    osg::ref_ptr<osg::Group> m_data = new osg::Group;
    std::vector<BodyNode> m_followers;
};

} // namespace trundle
