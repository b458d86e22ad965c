#pragma once
// Stand-in point for objects so far away that their triangles fall between pixels.

#include <osg/Group>

#include "scene/shaders/scene_shading.h"

namespace trundle {

/// One pixel in the mean colour of a geom node's shapes, drawn where they are a few pixels large or smaller. To be added beside
/// that node. In segmentation images it has the number of the node's largest geom. Null if no shape is opaque.
[[nodiscard]] osg::ref_ptr<osg::Node> makePointImpostor(const osg::Group& geomNode, const SceneShading& look);

} // namespace trundle
