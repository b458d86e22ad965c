// Planar shadows.
// Needs: flat floors. Assumes: the sun is the only light that casts them. Method: every caster is drawn once more for each
// layer, flattened onto the floor along a ray of light. The node's matrix flattens for culling; the program then puts the
// vertices exactly onto the plane. The stencil keeps a layer from darkening one pixel twice, and from leaving its floor.

#include <numbers>
#include <osg/BlendFunc>
#include <osg/Depth>

#include <osg/MatrixTransform>
#include <osg/PolygonOffset>
#include <osg/Stencil>

#include "scene/osg_types.h"
#include "scene/surroundings.h"

namespace trundle {
namespace {

constexpr double kHeightScale = 0.001; // what is left of a height, so that the program can still tell it
constexpr double kSunRadius = 0.034;   // rad; larger than the real one: robots are small
constexpr float kContactDepth = 0.35f; // darkness right below things, where the sky is hidden
constexpr float kNoTop = 1e9f;
constexpr float kContactTop = 0.05f; // m; what is higher hides little of it

/// Flattens the world onto the plane along `light`: p - (1 - k) h light / (n . light).
osg::Matrixd flattening(const Vec3& normal, const Vec3& point, const Vec3& light) {
    const Vec3 slide = light / normal.dot(light);
    const double offset = normal.dot(point);
    osg::Matrixd m;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            m(column, row) =
                (row == column ? 1.0 : 0.0) - slide[row] * normal[column] + kHeightScale * normal[row] * normal[column];
        }
        m(3, row) = offset * (slide[row] - kHeightScale * normal[row]);
    }
    return m;
}

osg::ref_ptr<osg::Node> makeLayer(const FloorPlane& floor, unsigned index, unsigned layer, const Vec3& light, float depth,
                                  float top, osg::Group& casters, const Look& look) {
    const Vec3 n = floor.normal(), p = floor.pose.position;
    osg::ref_ptr<osg::MatrixTransform> node = new osg::MatrixTransform(flattening(n, p, light));
    node->addChild(&casters);
    osg::StateSet* state = node->getOrCreateStateSet();
    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    state->setAttributeAndModes(look.shadow, force);
    state->addUniform(new osg::Uniform("shadowPlane", osg::Vec4(n.x(), n.y(), n.z(), n.dot(p))));
    state->addUniform(new osg::Uniform("shadowHeightScale", static_cast<float>(kHeightScale)));
    state->addUniform(new osg::Uniform("shadowDepth", depth));
    state->addUniform(new osg::Uniform("shadowTop", top));
    state->setMode(GL_CLIP_PLANE0, force);
    state->setMode(GL_CLIP_PLANE1, force);
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OVERRIDE | osg::StateAttribute::OFF);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0, 1, false), force);
    state->setAttributeAndModes(new osg::BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), force);
    state->setAttributeAndModes(new osg::PolygonOffset(-0.5f, -4.f), force);
    const unsigned bit = 1u << layer;
    osg::ref_ptr<osg::Stencil> once = new osg::Stencil;
    once->setFunction(osg::Stencil::EQUAL, static_cast<int>(floorMark(index)), kFloorBits | bit);
    once->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, osg::Stencil::INVERT);
    once->setWriteMask(bit);
    state->setAttributeAndModes(once, force);
    state->setRenderBinDetails(kDrawShadows, "RenderBin", osg::StateSet::OVERRIDE_RENDERBIN_DETAILS);
    return node;
}

Vec3 towardsSun(const Lighting& lighting) { return {lighting.sun.x(), lighting.sun.y(), lighting.sun.z()}; }

/// Share of what is shown that a shadow takes away (the screen's curve is a square root).
float fullDepth(const Lighting& lighting, const Vec3& n) {
    return 1 - std::sqrt(1 - lighting.sunShare(osg::Vec3(n.x(), n.y(), n.z())));
}

} // namespace

osg::ref_ptr<osg::Node> makeSharpShadow(const FloorPlane& floor, unsigned index, osg::Group& casters, const Look& look,
                                        const Lighting& lighting) {
    return makeLayer(floor, index, 0, towardsSun(lighting), fullDepth(lighting, floor.normal()), kNoTop, casters, look);
}

osg::ref_ptr<osg::Node> makeSoftShadow(const FloorPlane& floor, unsigned index, osg::Group& casters, const Look& look,
                                       const Lighting& lighting) {
    constexpr unsigned kSunLayers = kMostShadowLayers - 1;
    osg::ref_ptr<osg::Group> layers = new osg::Group;
    const Vec3 sun = towardsSun(lighting);
    const Vec3 side = sun.cross(Vec3::UnitX()).normalized(), other = sun.cross(side);
    const float each = 1 - std::pow(1 - fullDepth(lighting, floor.normal()), 1.f / kSunLayers);
    for (unsigned i = 0; i < kSunLayers; ++i) {
        const double turn = 2 * std::numbers::pi * i / kSunLayers + 0.3, reach = kSunRadius * (i % 2 ? 1.0 : 0.55);
        const Vec3 light = (sun + reach * (std::cos(turn) * side + std::sin(turn) * other)).normalized();
        if (floor.normal().dot(light) > 0.1) layers->addChild(makeLayer(floor, index, i, light, each, kNoTop, casters, look));
    }
    layers->addChild(makeLayer(floor, index, kSunLayers, floor.normal(), kContactDepth, kContactTop, casters, look));
    return layers;
}

} // namespace trundle
