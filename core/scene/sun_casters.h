#pragma once
// The extents of what casts sun shadows.

#include "scene/scene_objects.h"
#include "scene/shapes/bounds.h"

namespace trundle {

class SunCasters {
public:
    /// World bounding boxes of the objects at their poses.
    [[nodiscard]] std::vector<Bounds> boxes(const SceneObjects& objects);

private:
    [[nodiscard]] const Bounds& localBox(osg::Group& shapes);

    std::unordered_map<const osg::Group*, Bounds> m_boxes; // of the shapes of objects
};

} // namespace trundle
