#pragma once
// What is left of a thing so far away that its triangles fall between the pixels.

#include <osg/Group>

#include "scene/look.h"

namespace trundle {

/// One pixel in the mean colour of a geom node's shapes, drawn where they are a few pixels large or smaller. For beside the
/// node; it numbers itself as the largest of its geoms. Nothing where nothing of them is opaque.
[[nodiscard]] osg::ref_ptr<osg::Node> makeSpeck(const osg::Group& geomNode, const Look& look);

} // namespace trundle
