#pragma once
#include <vector>

#include <osg/Group>

#include "scene/nodes/pictures.h"
#include "scene/queries/poses.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

/// The lines of pens on the floor, in all images that show floors.
class PenNodes {
public:
    explicit PenNodes(osg::Group& scene);
    /// Replaces all.
    void set(const std::vector<PenLine>& lines, const SceneShading& look, Pictures& pictures);

private:
    osg::ref_ptr<osg::Group> m_nodes = new osg::Group;
};

/// A ribbon of its width along a line, a little above it, seen from above; with a round end on each corner.
[[nodiscard]] TriangleMesh ribbonOf(const PenLine& line);

} // namespace trundle
