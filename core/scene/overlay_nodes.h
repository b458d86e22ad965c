#pragma once
// The nodes of a scene's overlay (kMaskOverlay).

#include <span>

#include "scene/overlay.h"
#include "scene/scene_objects.h"
#include "scene/shaders/scene_shading.h"

namespace trundle {

class OverlayNodes {
public:
    OverlayNodes(osg::Group& scene, const SceneShading& look);
    /// Shapes with unknown body indices are skipped. `floorHeight`: m.
    void set(const SceneOverlay& overlay, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies, double floorHeight,
             const SceneShading& look);
    void followPoses() const { follow(m_followers); }

private:
    void setShapes(const std::vector<TintedShape>& shapes, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies);

    osg::ref_ptr<osg::Group> m_shapes = new osg::Group, m_floor = new osg::Group;
    std::vector<FollowingNode> m_followers;
    SceneOverlay m_overlaid;
};

} // namespace trundle
