#include "scene/nodes/flat_shadows.h"

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/osg_types.h"

namespace trundle {

FlatShadows::FlatShadows(const FloorPlane& floor, const Vec3& light, osg::Group& casters)
    : m_plane(floor.pose, light), m_casters(&casters) {
    osg::ref_ptr<osg::Geometry> shape = new osg::Geometry;
    shape->setUseDisplayList(false);
    shape->setUseVertexBufferObjects(true);
    shape->setVertexArray(m_points);
    shape->addPrimitiveSet(m_triangles);
    shape->setComputeBoundingBoxCallback(new NoBounds);
    shape->setCullingActive(false); // it holds only what the view shows
    addChild(shape);
}

void FlatShadows::traverse(osg::NodeVisitor& visitor) {
    osgUtil::CullVisitor* view = visitor.asCullVisitor();
    if (!view) return;
    m_points->clear();
    m_triangles->clear();
    gather(*m_casters, *view);
    if (m_triangles->empty()) return;
    m_points->dirty();
    m_triangles->dirty();
    osg::Group::traverse(visitor);
}

void FlatShadows::gather(const osg::Group& group, osgUtil::CullVisitor& view) {
    for (unsigned i = 0; i < group.getNumChildren(); ++i) {
        const osg::Node& child = *group.getChild(i);
        if (!view.validNodeMask(child)) continue;
        const osg::Group* inner = child.asGroup();
        if (!inner) continue;
        const osg::Transform* transform = child.asTransform();
        if (!transform) {
            gather(*inner, view);
            continue;
        }
        for (unsigned k = 0; k < inner->getNumChildren(); ++k)
            if (const auto* shapes = dynamic_cast<const GeomNode*>(inner->getChild(k)))
                add(*shapes, transform->asMatrixTransform()->getMatrix(), view);
    }
}

void FlatShadows::add(const GeomNode& shapes, const osg::Matrix& place, osgUtil::CullVisitor& view) {
    if (shapes.solids.empty()) return;
    const osg::BoundingSphere& own = shapes.getBound();
    const osg::Vec3d middle = osg::Vec3d(own.center()) * place;
    const Eigen::Vector2d at = m_plane.shadowOf(Vec3(middle.x(), middle.y(), middle.z()));
    const osg::BoundingSphere shadow(osg::Vec3(at.x(), at.y(), 0), own.radius() * m_plane.stretch());
    if (view.isCulled(shadow)) return;
    const double pixelsPerMetre = view.clampedPixelSize(shadow) / view.getLODScale() / (2 * shadow.radius());
    ShadowPlane::Frame body{Vec3(place(3, 0), place(3, 1), place(3, 2)), {}};
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) body.turn(row, column) = place(column, row);
    for (const ShadowSolid& solid : shapes.solids) {
        m_plane.cast(solid, body, pixelsPerMetre, m_outline);
        if (m_outline.size() < 3) continue;
        const auto first = static_cast<unsigned>(m_points->size());
        for (const Eigen::Vector2d& corner : m_outline) m_points->push_back(osg::Vec3(corner.x(), corner.y(), 0));
        for (unsigned i = 2; i < m_outline.size(); ++i)
            for (const unsigned corner : {first, first + i - 1, first + i}) m_triangles->push_back(corner);
    }
}

} // namespace trundle
