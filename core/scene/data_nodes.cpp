// Nodes for depth and segmentation images: a second node per body and static, with the number of its first geom.

#include <osg/BlendFunc>
#include <osg/Depth>

#include "scene/nodes/osg_types.h"
#include "scene/scene.h"

namespace trundle {

std::vector<std::string> objectNames(const ExperimentSpec& experiment) {
    std::vector<std::string> names{""};
    const auto add = [&](const std::string& owner, const std::vector<GeomSpec>& geoms) {
        for (const GeomSpec& geom : geoms) names.push_back(owner + "/" + geom.name);
    };
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) add(robot.name + "/" + body.name, body.geoms);
    }
    for (const StaticSpec& fixed : experiment.statics)
        if (fixed.geoms) add(fixed.name, *fixed.geoms);
    return names;
}

void Scene::makeData(const ExperimentSpec& experiment) {
    if (m_data->getStateSet()) return;
    osg::StateSet* state = m_data->getOrCreateStateSet();
    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    state->setAttributeAndModes(m_store->look.data, force);
    state->setMode(GL_BLEND, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, true), force);

    unsigned next = 1; // numbering of objectNames()
    const auto add = [&](const std::string& owner, const std::string& path, std::size_t geoms) {
        const Object* object = find(path);
        auto* leader = object ? dynamic_cast<osg::MatrixTransform*>(object->node.get()) : nullptr;
        const Object* whole = find(owner);
        const unsigned first = std::exchange(next, next + static_cast<unsigned>(geoms));
        if (!leader || !whole || !object->shapes) return;
        const osg::ref_ptr<osg::MatrixTransform> node = addDataNode(*object->shapes, first);
        if (leader->getNumChildren() > 1) node->addChild(leader->getChild(1)); // its impostor
        m_dataFollowers.push_back({node, leader, whole->node});
    };
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) add(robot.name, robot.name + "/" + body.name, body.geoms.size());
    }
    for (const StaticSpec& fixed : experiment.statics) {
        if (!fixed.geoms) continue;
        unsigned plane = next;
        for (const GeomSpec& geom : *fixed.geoms) {
            const Object* floor = geom.shape == GeomShape::Plane ? find(fixed.name + "/" + geom.name) : nullptr;
            auto* leader = floor ? dynamic_cast<osg::MatrixTransform*>(floor->node.get()) : nullptr;
            if (leader && leader->getNumChildren() > 0)
                m_dataFollowers.push_back({addDataNode(*leader->getChild(0), plane), leader, floor->node});
            ++plane;
        }
        add(fixed.name, fixed.name, fixed.geoms->size());
    }
}

osg::ref_ptr<osg::MatrixTransform> Scene::addDataNode(osg::Node& shapes, unsigned firstObject) {
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform;
    node->setDataVariance(osg::Object::DYNAMIC);
    node->addChild(&shapes);
    node->getOrCreateStateSet()->addUniform(new osg::Uniform("firstObject", static_cast<float>(firstObject)));
    m_data->addChild(node);
    return node;
}

void Scene::followData() {
    for (const DataBodyNode& follower : m_dataFollowers) {
        follower.node->setMatrix(follower.leader->getMatrix());
        follower.node->setNodeMask(follower.leader->getNodeMask() && follower.whole->getNodeMask() ? ~0u : 0);
    }
}

} // namespace trundle
