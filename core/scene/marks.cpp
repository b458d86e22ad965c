// Outlined and hidden objects of a scene.

#include <osg/PolygonMode>

#include "scene/nodes/geom_nodes.h"
#include "scene/scene.h"

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

const Scene::Object* Scene::find(const std::string& path) const {
    const auto it = m_objects.find(path);
    return it == m_objects.end() ? nullptr : &it->second;
}

std::pair<const Scene::Object*, std::uint32_t> Scene::findGeom(const std::string& path) const {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return {nullptr, 0};
    const Object* owner = find(path.substr(0, slash));
    if (!owner || !owner->shapes) return {nullptr, 0};
    const auto geom = geomNamed(*owner->shapes, std::string_view(path).substr(slash + 1));
    return geom ? std::pair{owner, *geom} : std::pair<const Object*, std::uint32_t>{nullptr, 0};
}

void Scene::mark(osg::Group& group, const std::string& path) {
    if (const Object* object = find(path)) {
        // An infinite floor has no outline.
        const bool isFloor = !object->shapes && path.find('/') != std::string::npos;
        if (!isFloor) group.addChild(object->node);
        return;
    }
    const auto [owner, geom] = findGeom(path);
    auto* leader = owner ? dynamic_cast<osg::MatrixTransform*>(owner->node.get()) : nullptr;
    if (!leader) return;
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(leader->getMatrix());
    node->addChild(partOf(*owner->shapes, [geom = geom](std::uint32_t g) { return g == geom; }));
    group.addChild(node);
    m_markFollowers.push_back({node, leader});
}

void Scene::setMarks(const SceneMarks& marks) {
    if (marks == m_marked) return;
    m_marked = marks;
    m_marks->removeChildren(0, m_marks->getNumChildren());
    m_markFollowers.clear();
    if (!m_marks->getStateSet()) SceneShading::applyTo(*m_marks->getOrCreateStateSet(), m_uniforms);
    const osg::ref_ptr<osg::Group> selected = markGroup(m_store->look, {1, 0, 0, 1}),
                                   hovered = markGroup(m_store->look, {0, 1, 0, 1});
    for (const std::string& path : marks.selected) mark(*selected, path);
    for (const std::string& path : marks.hovered) mark(*hovered, path);
    m_marks->addChild(selected);
    m_marks->addChild(hovered);
}

void Scene::setHidden(const std::vector<std::string>& paths) {
    if (paths == m_hidden) return;
    const auto show = [](const Object& object, osg::Group* shapes) {
        if (!object.shapes) return;
        if (object.node->getNumChildren() > 0) object.node->setChild(0, shapes);
    };
    // Floors of a static are separate nodes.
    const auto maskFloors = [&](const std::string& owner, unsigned mask) {
        for (const auto& [name, object] : m_objects)
            if (!object.shapes && name.size() > owner.size() && name[owner.size()] == '/' && name.starts_with(owner))
                object.node->setNodeMask(mask);
    };
    for (const std::string& path : m_hidden) {
        maskFloors(path, ~0u);
        if (const Object* object = find(path)) object->node->setNodeMask(~0u);
        else if (const Object* owner = findGeom(path).first) show(*owner, owner->shapes);
    }
    m_hidden = paths;
    std::map<const Object*, std::vector<std::uint32_t>> left; // hidden geoms by object
    for (const std::string& path : m_hidden) {
        if (const Object* object = find(path)) object->node->setNodeMask(0);
        else if (const auto [owner, geom] = findGeom(path); owner) left[owner].push_back(geom);
        maskFloors(path, 0);
    }
    for (const auto& [owner, geoms] : left) {
        show(*owner, partOf(*owner->shapes, [&, geoms = geoms](std::uint32_t g) {
            return std::find(geoms.begin(), geoms.end(), g) == geoms.end();
        }));
    }
}

void Scene::setWireframe(bool on) {
    if (on == m_wireframe) return;
    m_wireframe = on;
    for (osg::Group* group : {m_robots.get(), m_statics.get()}) {
        osg::StateSet* state = group->getOrCreateStateSet();
        if (!on) {
            state->removeAttribute(osg::StateAttribute::POLYGONMODE);
            continue;
        }
        state->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::LINE),
                                    osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON);
    }
}

} // namespace trundle
