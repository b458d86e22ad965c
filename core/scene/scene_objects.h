#pragma once
// The nodes of a scene by the paths of its objects, and which of them are hidden.

#include <string>
#include <unordered_map>
#include <vector>

#include <osg/MatrixTransform>

namespace trundle {

struct SceneObject {
    osg::ref_ptr<osg::Group> node;
    osg::ref_ptr<osg::Group> shapes; ///< its geoms; null for a robot, whose bodies hold them, and for a floor

    /// Where its geoms are; nullptr for a robot.
    [[nodiscard]] osg::MatrixTransform* transform() const { return dynamic_cast<osg::MatrixTransform*>(node.get()); }
};

class SceneObjects {
public:
    /// The first of a path stays.
    void add(const std::string& path, SceneObject object) { m_objects.try_emplace(path, std::move(object)); }
    [[nodiscard]] const std::unordered_map<std::string, SceneObject>& all() const { return m_objects; }
    [[nodiscard]] const SceneObject* find(const std::string& path) const;
    /// The object that owns the geom at that path, and the geom's index in it.
    [[nodiscard]] std::pair<const SceneObject*, std::uint32_t> findGeom(const std::string& path) const;
    /// Hides objects and geoms in all images; unknown paths are ignored.
    void setHidden(const std::vector<std::string>& paths);

private:
    void maskParts(const std::string& owner, unsigned mask);

    std::unordered_map<std::string, SceneObject> m_objects; // by path
    std::vector<std::string> m_hidden;
};

/// A node that copies the pose of another one.
struct FollowingNode {
    osg::ref_ptr<osg::MatrixTransform> node, leader;
};
inline void follow(const std::vector<FollowingNode>& nodes) {
    for (const FollowingNode& each : nodes) each.node->setMatrix(each.leader->getMatrix());
}

} // namespace trundle
