#pragma once
// The sun's shadows of convex geoms on one floor: polygons, calculated for each picture of what the picture shows of them.

#include <osg/Geometry>
#include <osg/Group>
#include <osgUtil/CullVisitor>

#include "scene/nodes/surroundings.h"
#include "scene/shapes/flat_shadow.h"

namespace trundle {

class GeomNode;

/// Below a transform to the frame of the floor.
class FlatShadows final : public osg::Group {
public:
    /// `light` leads to the light. `casters` holds transforms with geom nodes, at any depth.
    FlatShadows(const FloorPlane& floor, const Vec3& light, osg::Group& casters);

    void traverse(osg::NodeVisitor& visitor) override;

private:
    void gather(const osg::Group& group, osgUtil::CullVisitor& view);
    void add(const GeomNode& shapes, const osg::Matrix& place, osgUtil::CullVisitor& view);

    ShadowPlane m_plane;
    osg::ref_ptr<osg::Group> m_casters;
    osg::ref_ptr<osg::Vec3Array> m_points = new osg::Vec3Array;
    osg::ref_ptr<osg::DrawElementsUInt> m_triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    ShadowPlane::Outline m_outline; // scratch
};

} // namespace trundle
