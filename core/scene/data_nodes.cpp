#include "scene/data_nodes.h"

#include <osg/BlendFunc>
#include <osg/Depth>

#include "scene/nodes/masks.h"

namespace trundle {

DataNodes::DataNodes(osg::Group& scene) {
    m_data->setNodeMask(kMaskData);
    scene.addChild(m_data);
}

void DataNodes::make(const ExperimentSpec& experiment, const SceneObjects& objects, const SceneShading& look) {
    if (m_data->getStateSet()) return;
    osg::StateSet* state = m_data->getOrCreateStateSet();
    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    state->setAttributeAndModes(look.data, force);
    state->setMode(GL_BLEND, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, true), force);

    unsigned next = 1; // numbering of objectNames() in model
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) {
            add(objects.find(robot.name + "/" + body.name), objects.find(robot.name), next);
            next += static_cast<unsigned>(body.geoms.size());
        }
    }
    for (const StaticSpec& fixed : experiment.statics) {
        if (!fixed.geoms) continue;
        addStatic(fixed, next, objects);
        next += static_cast<unsigned>(fixed.geoms->size());
    }
}

void DataNodes::addStatic(const StaticSpec& fixed, unsigned firstObject, const SceneObjects& objects) {
    unsigned plane = firstObject;
    for (const GeomSpec& geom : *fixed.geoms) {
        const SceneObject* floor = geom.shape == GeomShape::Plane ? objects.find(fixed.name + "/" + geom.name) : nullptr;
        osg::MatrixTransform* leader = floor ? floor->transform() : nullptr;
        if (leader && leader->getNumChildren() > 0)
            m_followers.push_back({addNode(*leader->getChild(0), plane), leader, floor->node});
        ++plane;
    }
    const SceneObject* object = objects.find(fixed.name);
    add(object, object, firstObject);
}

/// A body of a robot, or a static.
void DataNodes::add(const SceneObject* object, const SceneObject* whole, unsigned firstObject) {
    osg::MatrixTransform* leader = object ? object->transform() : nullptr;
    if (!leader || !whole || !object->shapes) return;
    const osg::ref_ptr<osg::MatrixTransform> node = addNode(*object->shapes, firstObject);
    if (leader->getNumChildren() > 1) node->addChild(leader->getChild(1)); // its impostor
    m_followers.push_back({node, leader, whole->node});
}

osg::ref_ptr<osg::MatrixTransform> DataNodes::addNode(osg::Node& shapes, unsigned firstObject) {
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
    node->setDataVariance(osg::Object::DYNAMIC);
    node->addChild(&shapes);
    node->getOrCreateStateSet()->addUniform(new osg::Uniform("firstObject", static_cast<float>(firstObject)));
    m_data->addChild(node);
    return node;
}

void DataNodes::followObjects() const {
    for (const BodyNode& follower : m_followers) {
        follower.node->setMatrix(follower.leader->getMatrix());
        follower.node->setNodeMask(follower.leader->getNodeMask() && follower.whole->getNodeMask() ? ~0u : 0);
    }
}

} // namespace trundle
