#include "scene/mark_nodes.h"

#include "scene/nodes/geom_nodes.h"

namespace trundle {
namespace {

osg::ref_ptr<osg::Group> markGroup(const SceneShading& look, const osg::Vec4& colour) {
    osg::ref_ptr<osg::Group> group = new osg::Group;
    osg::StateSet* state = group->getOrCreateStateSet();
    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    state->setAttributeAndModes(look.flat, force);
    state->addUniform(new osg::Uniform("flatColour", colour));
    state->setMode(GL_BLEND, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    return group;
}

} // namespace

void MarkNodes::mark(osg::Group& group, const std::string& path, const SceneObjects& objects) {
    if (const SceneObject* object = objects.find(path)) {
        // An infinite floor has no outline.
        const bool isFloor = !object->shapes && path.find('/') != std::string::npos;
        if (!isFloor) group.addChild(object->node);
        return;
    }
    const auto [owner, geom] = objects.findGeom(path);
    osg::MatrixTransform* leader = owner ? owner->transform() : nullptr;
    if (!leader) return;
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(leader->getMatrix());
    node->addChild(partOf(*owner->shapes, [geom = geom](std::uint32_t g) { return g == geom; }));
    group.addChild(node);
    m_followers.push_back({node, leader});
}

void MarkNodes::set(const SceneMarks& marks, const SceneObjects& objects, const SceneShading& look, SceneUniforms& uniforms) {
    if (marks == m_marked) return;
    m_marked = marks;
    m_marks->removeChildren(0, m_marks->getNumChildren());
    m_followers.clear();
    if (!m_marks->getStateSet()) SceneShading::applyTo(*m_marks->getOrCreateStateSet(), uniforms);
    const osg::ref_ptr<osg::Group> selected = markGroup(look, {1, 0, 0, 1}), hovered = markGroup(look, {0, 1, 0, 1});
    for (const std::string& path : marks.selected) mark(*selected, path, objects);
    for (const std::string& path : marks.hovered) mark(*hovered, path, objects);
    m_marks->addChild(selected);
    m_marks->addChild(hovered);
}

} // namespace trundle
