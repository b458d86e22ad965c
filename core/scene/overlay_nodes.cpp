#include "scene/overlay_nodes.h"

#include <cstring>
#include <map>

#include <osg/Geometry>
#include <osg/Texture2D>

#include "scene/nodes/masks.h"
#include "scene/nodes/osg_types.h"

namespace trundle {
namespace {

osg::ref_ptr<osg::Geometry> geometryOf(const TintedMesh& mesh) {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array, normals = new osg::Vec3Array;
    osg::ref_ptr<osg::Vec4ubArray> colours = new osg::Vec4ubArray;
    for (const Eigen::Vector3f& p : mesh.points) points->push_back({p.x(), p.y(), p.z()});
    for (const Eigen::Vector3f& n : mesh.normals) normals->push_back({n.x(), n.y(), n.z()});
    for (const auto& c : mesh.colours) colours->push_back({c[0], c[1], c[2], 255});
    colours->setNormalize(true);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setVertexArray(points);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES, mesh.indices.begin(), mesh.indices.end()));
    return geometry;
}

osg::ref_ptr<osg::Node> floorNode(const FloorPicture& floor, double height, const SceneShading& look) {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    for (const auto& [right, far] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
        points->push_back(osg::Vec3(floor.x + right * floor.width, floor.y + far * floor.depth, height));
    osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
    quad->setUseDisplayList(false);
    quad->setUseVertexBufferObjects(true);
    quad->setVertexArray(points);
    quad->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));

    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(int(floor.columns), int(floor.rows), 1, GL_RGBA, GL_UNSIGNED_BYTE, 1);
    std::memcpy(image->data(), floor.pixels.data(), floor.pixels.size());
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D(image);
    texture->setResizeNonPowerOfTwoHint(false);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::LINEAR);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::LINEAR);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet(*look.floorTint, osg::CopyOp::SHALLOW_COPY);
    state->setTextureAttribute(kPictureUnit, texture);
    state->addUniform(new osg::Uniform("picture", int(kPictureUnit)));
    state->addUniform(new osg::Uniform("pictureArea", osg::Vec4(floor.x, floor.y, 1 / floor.width, 1 / floor.depth)));
    quad->setStateSet(state);
    return quad;
}

bool isWhole(const FloorPicture& floor) {
    return floor.width > 0 && floor.depth > 0 && floor.columns > 0 && floor.rows > 0 &&
           floor.pixels.size() == std::size_t(floor.columns) * floor.rows * 4;
}

} // namespace

OverlayNodes::OverlayNodes(osg::Group& scene, const SceneShading& look) {
    m_shapes->setNodeMask(kMaskOverlay);
    m_shapes->setStateSet(look.tinted);
    m_floor->setNodeMask(kMaskOverlay);
    scene.addChild(m_shapes);
    scene.addChild(m_floor);
}

void OverlayNodes::setShapes(const std::vector<TintedShape>& shapes, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies) {
    m_shapes->removeChildren(0, m_shapes->getNumChildren());
    m_followers.clear();
    std::map<const TintedMesh*, osg::ref_ptr<osg::Geometry>> known;
    for (const TintedShape& shape : shapes) {
        if (!shape.mesh || shape.body >= bodies.size()) continue;
        osg::ref_ptr<osg::Geometry>& geometry = known[shape.mesh.get()];
        if (!geometry) geometry = geometryOf(*shape.mesh);
        osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(bodies[shape.body]->getMatrix()),
                                           mounting = new osg::MatrixTransform(toOsg(shape.mounting));
        place->setDataVariance(osg::Object::DYNAMIC);
        mounting->addChild(geometry);
        place->addChild(mounting);
        m_shapes->addChild(place);
        m_followers.push_back({place, bodies[shape.body]});
    }
}

void OverlayNodes::set(const SceneOverlay& overlay, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies,
                       double floorHeight, const SceneShading& look) {
    if (overlay.shapes != m_overlaid.shapes) setShapes(overlay.shapes ? *overlay.shapes : std::vector<TintedShape>(), bodies);
    if (overlay.floor != m_overlaid.floor) {
        m_floor->removeChildren(0, m_floor->getNumChildren());
        if (overlay.floor && isWhole(*overlay.floor)) m_floor->addChild(floorNode(*overlay.floor, floorHeight, look));
    }
    m_overlaid = overlay;
}

} // namespace trundle
