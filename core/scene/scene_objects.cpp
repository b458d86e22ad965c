#include "scene/scene_objects.h"

#include <algorithm>
#include <map>

#include "scene/nodes/geom_nodes.h"

namespace trundle {

const SceneObject* SceneObjects::find(const std::string& path) const {
    const auto it = m_objects.find(path);
    return it == m_objects.end() ? nullptr : &it->second;
}

std::pair<const SceneObject*, std::uint32_t> SceneObjects::findGeom(const std::string& path) const {
    const std::size_t slash = path.rfind('/');
    if (slash == std::string::npos) return {nullptr, 0};
    const SceneObject* owner = find(path.substr(0, slash));
    if (!owner || !owner->shapes) return {nullptr, 0};
    const auto geom = geomNamed(*owner->shapes, std::string_view(path).substr(slash + 1));
    return geom ? std::pair{owner, *geom} : std::pair<const SceneObject*, std::uint32_t>{nullptr, 0};
}

/// Floors of a static and what moves in it are separate nodes.
void SceneObjects::maskParts(const std::string& owner, unsigned mask) {
    for (const auto& [name, object] : m_objects)
        if (name.size() > owner.size() && name[owner.size()] == '/' && name.starts_with(owner)) object.node->setNodeMask(mask);
}

void SceneObjects::setHidden(const std::vector<std::string>& paths) {
    if (paths == m_hidden) return;
    const auto show = [](const SceneObject& object, osg::Group* shapes) {
        if (!object.shapes) return;
        if (object.node->getNumChildren() > 0) object.node->setChild(0, shapes);
    };
    for (const std::string& path : m_hidden) {
        maskParts(path, ~0u);
        if (const SceneObject* object = find(path)) object->node->setNodeMask(~0u);
        else if (const SceneObject* owner = findGeom(path).first) show(*owner, owner->shapes);
    }
    m_hidden = paths;
    std::map<const SceneObject*, std::vector<std::uint32_t>> left; // hidden geoms by object
    for (const std::string& path : m_hidden) {
        if (const SceneObject* object = find(path)) object->node->setNodeMask(0);
        else if (const auto [owner, geom] = findGeom(path); owner) left[owner].push_back(geom);
        maskParts(path, 0);
    }
    for (const auto& [owner, geoms] : left) {
        show(*owner, partOf(*owner->shapes, [&, geoms = geoms](std::uint32_t g) {
            return std::find(geoms.begin(), geoms.end(), g) == geoms.end();
        }));
    }
}

} // namespace trundle
