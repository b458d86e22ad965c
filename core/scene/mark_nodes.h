#pragma once
// Outlined objects of a scene: selected ones in pure red, hovered ones in pure green.

#include "scene/scene_marks.h"
#include "scene/scene_objects.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

class MarkNodes {
public:
    [[nodiscard]] osg::Group& root() { return *m_marks; }
    void set(const SceneMarks& marks, const SceneObjects& objects, const SceneShading& look, SceneUniforms& uniforms);
    void followPoses() const { follow(m_followers); }

private:
    void mark(osg::Group& group, const std::string& path, const SceneObjects& objects);

    osg::ref_ptr<osg::Group> m_marks = new osg::Group;
    std::vector<FollowingNode> m_followers;
    SceneMarks m_marked;
};

} // namespace trundle
