#include "scene/collision_nodes.h"

#include "scene/nodes/masks.h"

namespace trundle {

CollisionNodes::CollisionNodes(osg::Group& scene, const SceneShading& look) {
    m_collision->setNodeMask(kMaskCollision);
    m_collision->setStateSet(look.collision);
    scene.addChild(m_collision);
}

void CollisionNodes::make(const ExperimentSpec& experiment, const SceneObjects& objects, ShapeStore& store) {
    if (m_collision->getNumChildren() > 0) return;
    const auto add = [&](const std::string& path, std::span<const GeomSpec> geoms) {
        const SceneObject* object = objects.find(path);
        osg::MatrixTransform* leader = object ? object->transform() : nullptr;
        if (!leader) return;
        osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(leader->getMatrix());
        node->addChild(store.collisionNodeOf(geoms));
        m_collision->addChild(node);
        m_followers.push_back({node, leader});
    };
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) add(robot.name + "/" + body.name, body.geoms);
    }
    for (const StaticSpec& fixed : experiment.statics)
        if (fixed.geoms) add(fixed.name, *fixed.geoms);
}

} // namespace trundle
