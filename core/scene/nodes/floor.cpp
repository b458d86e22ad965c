#include <osg/Depth>
#include <osg/Geometry>
#include <osg/MatrixTransform>
#include <osg/PolygonOffset>
#include <osg/Stencil>

#include "scene/nodes/osg_types.h"
#include "scene/nodes/surroundings.h"

namespace trundle {
namespace {

/// A quad in the plane z = 0, centred on (x, y).
osg::ref_ptr<osg::Geometry> makeQuad(double x, double y, double reach) {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    for (const auto& [dx, dy] : {std::pair{-reach, -reach}, {reach, -reach}, {reach, reach}, {-reach, reach}})
        points->push_back(osg::Vec3(x + dx, y + dy, 0));
    osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
    quad->setUseDisplayList(false);
    quad->setUseVertexBufferObjects(true);
    quad->setVertexArray(points);
    quad->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_FAN, 0, 4));
    return quad;
}

} // namespace

std::vector<FloorPlane> floorPlanes(const ExperimentSpec& experiment) {
    std::vector<FloorPlane> floors;
    for (const StaticSpec& fixed : experiment.statics) {
        if (!fixed.geoms) continue;
        for (const GeomSpec& geom : *fixed.geoms) {
            if (geom.shape != GeomShape::Plane || !geom.visible) continue;
            FloorPlane floor;
            floor.pose = fixed.pose * geom.pose;
            floor.path = fixed.name + "/" + geom.name;
            if (geom.material < experiment.materials.size()) {
                const MaterialSpec& material = experiment.materials[geom.material];
                floor.colour = material.colour;
                floor.picture = material.picture;
                floor.pictureScale = material.textureScale;
            }
            if (!floor.pose.position.allFinite() || !floor.pose.rotation.coeffs().allFinite() || floor.pose.position.norm() > 1e6)
                continue;
            const bool known = std::any_of(floors.begin(), floors.end(), [&](const FloorPlane& other) {
                return other.normal().dot(floor.normal()) > 1 - 1e-9 &&
                       std::abs(floor.normal().dot(other.pose.position - floor.pose.position)) < 1e-6;
            });
            if (!known) floors.push_back(std::move(floor));
        }
    }
    return floors;
}

std::optional<std::size_t> levelFloor(const std::vector<FloorPlane>& floors) {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < floors.size(); ++i) {
        if (floors[i].normal().z() < 0.999) continue;
        if (!best || floors[i].pose.position.z() > floors[*best].pose.position.z()) best = i;
    }
    return best;
}

osg::ref_ptr<osg::Node> makeFloorNode(const FloorPlane& floor, unsigned index, const Bounds& about, double reach,
                                      const SceneShading& look, Pictures& pictures, const Lighting& lighting) {
    // The quad keeps the plane's own frame, so that the grid lines stay aligned with the plane's Pos in the text.
    const Vec3 middle = about.empty() ? floor.pose.position : about.centre();
    const Vec3 local = floor.pose.inverse() * middle;
    const osg::ref_ptr<osg::Geometry> quad = makeQuad(local.x(), local.y(), reach);
    quad->setTexCoordArray(kLayerUnit, new osg::FloatArray(4), osg::Array::BIND_PER_VERTEX);

    osg::StateSet* state = quad->getOrCreateStateSet();
    state->setAttributeAndModes(floor.picture ? look.picturedFloor : look.floor);
    if (floor.picture) {
        state->setTextureAttribute(kPictureUnit, pictures.textureOf(floor.picture));
        state->addUniform(new osg::Uniform("picture", int(kPictureUnit)));
        state->addUniform(new osg::Uniform("pictureScale", static_cast<float>(floor.pictureScale)));
    }
    const auto share = [](double v) { return static_cast<float>(std::clamp(v, 0.0, 1.0)); };
    state->addUniform(
        new osg::Uniform("floorColour", osg::Vec3(share(floor.colour[0]), share(floor.colour[1]), share(floor.colour[2]))));
    const Vec3 n = floor.normal();
    state->addUniform(new osg::Uniform("floorLight", lighting.on(osg::Vec3(n.x(), n.y(), n.z()))));
    state->addUniform(new osg::Uniform("floorNormal", osg::Vec3(n.x(), n.y(), n.z())));
    // Surfaces in the plane of a floor are drawn over the floor.
    state->setAttributeAndModes(new osg::PolygonOffset(1.f + index, 2.f + index));
    osg::ref_ptr<osg::Stencil> mark = new osg::Stencil;
    mark->setFunction(osg::Stencil::ALWAYS, floorMark(index), ~0u);
    mark->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::REPLACE);
    state->setAttributeAndModes(mark);
    state->setRenderBinDetails(kDrawFloor, "RenderBin");

    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(toOsg(floor.pose));
    node->setName(floor.path);
    node->addChild(quad);
    return node;
}

osg::ref_ptr<osg::Node> makeGuideNode(const Bounds& about, double reach, const SceneShading& look) {
    const Vec3 middle = about.empty() ? Vec3(Vec3::Zero()) : about.centre();
    const osg::ref_ptr<osg::Geometry> quad = makeQuad(middle.x(), middle.y(), reach);
    quad->setStateSet(look.guide);
    quad->setName("guide");
    return quad;
}

osg::ref_ptr<osg::Node> makeWholeNode() {
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array;
    points->push_back(osg::Vec3(-1, -1, 0));
    points->push_back(osg::Vec3(3, -1, 0));
    points->push_back(osg::Vec3(-1, 3, 0));
    osg::ref_ptr<osg::Geometry> triangle = new osg::Geometry;
    triangle->setUseDisplayList(false);
    triangle->setUseVertexBufferObjects(true);
    triangle->setVertexArray(points);
    triangle->addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLES, 0, 3));
    // It covers the whole image from any pose, so its bounds have no meaning.
    triangle->setCullingActive(false);
    triangle->setComputeBoundingBoxCallback(new NoBounds);
    return triangle;
}

osg::ref_ptr<osg::Node> makeSkyNode(const SceneShading& look) {
    const osg::ref_ptr<osg::Node> sky = makeWholeNode();
    sky->setStateSet(look.sky);
    sky->setName("sky");
    return sky;
}

} // namespace trundle
