// Planar shadows.
// Needs: flat floors. Assumes: the sun and a few lamps cast them. Method: the sun's shadows of convex geoms are polygons
//   (FlatShadows). Every other caster is drawn once more per layer, flattened onto the floor along the light. For the sun, the
//   node's matrix flattens approximately, so that culling works; the program then moves the vertices exactly onto the plane. The
//   stencil prevents a layer from darkening a pixel twice and from leaving its floor.

#include <numbers>
#include <osg/BlendFunc>
#include <osg/CullFace>
#include <osg/Depth>
#include <osg/MatrixTransform>
#include <osg/PolygonOffset>
#include <osg/Stencil>

#include "scene/nodes/flat_shadows.h"
#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/osg_types.h"
#include "scene/nodes/surroundings.h"

namespace trundle {
namespace {

constexpr double kHeightScale = 0.001; // factor on heights above the floor; not 0, so that the program can recover them
constexpr double kSunRadius = 0.034;   // rad; larger than the real one, because robots are small
constexpr float kContactDepth = 0.35f; // darkness directly below objects, which hide the sky
constexpr float kNoTop = 1e9f;
constexpr float kContactTop = 0.05f; // m; higher parts hide little of it

constexpr double kLeastSlant = 0.2;        // cosine; at more grazing light shadows become too long
constexpr float kLeastLampHeight = 0.05f;  // m above the floor
constexpr std::size_t kMaxShadowLamps = 3; // each uses one layer

float heightOf(const Lamp& lamp, const FloorPlane& floor) {
    const Vec3 place(lamp.place.x(), lamp.place.y(), lamp.place.z());
    return static_cast<float>(floor.normal().dot(place - floor.pose.position));
}

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

/// State common to all layers: drawn only where their floor is visible, once per pixel.
void setLayerState(osg::Node& node, const FloorPlane& floor, unsigned index, unsigned layer,
                   const osg::ref_ptr<osg::Program>& program) {
    const Vec3 n = floor.normal();
    osg::StateSet* state = node.getOrCreateStateSet();
    const unsigned force = osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON;
    state->setAttributeAndModes(program, force);
    state->addUniform(new osg::Uniform("shadowPlane", osg::Vec4(n.x(), n.y(), n.z(), n.dot(floor.pose.position))));
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
}

/// How much one layer darkens.
struct ShadowStrength {
    float depth = 0;    ///< fraction of the displayed brightness removed where there are no lamps
    float sunPower = 0; ///< remaining light is (1 - sun's share)^sunPower; 0: the layer does not hide the sun
    float top = kNoTop;
};

void setDarkness(osg::StateSet& state, const FloorPlane& floor, ShadowStrength dark, const Lighting& lighting) {
    const Vec3 n = floor.normal();
    const osg::Vec3 normal(n.x(), n.y(), n.z());
    state.addUniform(new osg::Uniform("shadowDepth", dark.depth));
    state.addUniform(new osg::Uniform("floorLight", lighting.on(normal)));
    state.addUniform(new osg::Uniform("floorNormal", normal));
    state.addUniform(new osg::Uniform("sunShare", lighting.sunShare(normal)));
    state.addUniform(new osg::Uniform("sunPower", dark.sunPower));
}

/// Casters drawn flattened.
osg::ref_ptr<ShadowTransform> makeLayer(const FloorPlane& floor, unsigned index, unsigned layer, const Vec3& light,
                                        ShadowStrength dark, osg::Group& casters, const SceneShading& look,
                                        const Lighting& lighting) {
    osg::ref_ptr<ShadowTransform> node = new ShadowTransform(flattening(floor.normal(), floor.pose.position, light));
    osg::StateSet* state = node->getOrCreateStateSet();
    setDarkness(*state, floor, dark, lighting);
    state->addUniform(new osg::Uniform("shadowHeightScale", static_cast<float>(kHeightScale)));
    state->addUniform(new osg::Uniform("shadowTop", dark.top));
    state->setMode(GL_CLIP_PLANE0, osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON);
    if (dark.top < kNoTop) {
        // For contact shadows the lower sides of the casters count, otherwise the sides towards the light.
        state->setMode(GL_CLIP_PLANE1, osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON);
        state->setAttributeAndModes(new osg::CullFace(osg::CullFace::FRONT));
    }
    node->addChild(&casters);
    setLayerState(*node, floor, index, layer, look.shadow);
    return node;
}

osg::ref_ptr<osg::Node> makeSunLayer(const FloorPlane& floor, unsigned index, unsigned layer, const Vec3& light,
                                     ShadowStrength dark, osg::Group& casters, const SceneShading& look,
                                     const Lighting& lighting) {
    osg::ref_ptr<osg::Group> both = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> flat = new osg::MatrixTransform(toOsg(floor.pose));
    flat->addChild(new FlatShadows(floor, light, casters));
    setDarkness(*flat->getOrCreateStateSet(), floor, dark, lighting);
    setLayerState(*flat, floor, index, layer, look.flatShadow);
    both->addChild(flat);
    if (hasOpenCasters(casters)) {
        const osg::ref_ptr<ShadowTransform> open = makeLayer(floor, index, layer, light, dark, casters, look, lighting);
        open->castOpenOnes();
        both->addChild(open);
    }
    return both;
}

/// Shadow of a lamp. The program projects the casters from their own positions, which may be far from the floor.
osg::ref_ptr<osg::Node> makeLampLayer(const FloorPlane& floor, unsigned index, unsigned layer, const Lamp& lamp,
                                      const Lighting& lighting, osg::Group& casters, const SceneShading& look) {
    osg::ref_ptr<ShadowTransform> node = new ShadowTransform;
    node->castEverywhere();
    osg::StateSet* state = node->getOrCreateStateSet();
    const Vec3 n = floor.normal();
    const osg::Vec3 normal(n.x(), n.y(), n.z());
    state->addUniform(new osg::Uniform("shadowLamp", lamp.place));
    state->addUniform(new osg::Uniform("shadowLight", lamp.light));
    state->addUniform(new osg::Uniform("lampHeight", heightOf(lamp, floor)));
    state->addUniform(new osg::Uniform("floorLight", lighting.on(normal)));
    state->addUniform(new osg::Uniform("floorNormal", normal));
    for (const unsigned plane : {GL_CLIP_PLANE0, GL_CLIP_PLANE1, GL_CLIP_PLANE2})
        state->setMode(plane, osg::StateAttribute::OVERRIDE | osg::StateAttribute::ON);
    node->addChild(&casters);
    setLayerState(*node, floor, index, layer, look.lampShadow);
    return node;
}

Vec3 towardsSun(const Lighting& lighting) { return {lighting.sun.x(), lighting.sun.y(), lighting.sun.z()}; }

bool sunCasts(const Lighting& lighting, const FloorPlane& floor) {
    return lighting.shadows && floor.normal().dot(towardsSun(lighting)) >= kLeastSlant;
}

/// The first kMaxShadowLamps lamps that cast shadows on a floor.
std::vector<Lamp> castingLamps(const Lighting& lighting, const FloorPlane& floor) {
    std::vector<Lamp> lamps;
    for (const Lamp& lamp : lighting.lamps)
        if (lamp.shadows && heightOf(lamp, floor) > kLeastLampHeight && lamps.size() < kMaxShadowLamps) lamps.push_back(lamp);
    return lamps;
}

/// Lamps use the last layers.
unsigned firstLampLayer(const std::vector<Lamp>& lamps) { return kMaxShadowLayers - static_cast<unsigned>(lamps.size()); }

/// Fraction of the displayed brightness that a full shadow removes (the display curve is a square root).
float fullDepth(const Lighting& lighting, const Vec3& n) {
    return 1 - std::sqrt(1 - lighting.sunShare(osg::Vec3(n.x(), n.y(), n.z())));
}

} // namespace

osg::ref_ptr<osg::Node> makeSharpShadow(const FloorPlane& floor, unsigned index, osg::Group& casters, const SceneShading& look,
                                        const Lighting& lighting) {
    osg::ref_ptr<osg::Group> layers = new osg::Group;
    if (sunCasts(lighting, floor))
        layers->addChild(makeSunLayer(floor, index, 0, towardsSun(lighting), {fullDepth(lighting, floor.normal()), 0.5f}, casters,
                                      look, lighting));
    return layers;
}

osg::ref_ptr<osg::Node> makeSoftShadow(const FloorPlane& floor, unsigned index, osg::Group& casters, const SceneShading& look,
                                       const Lighting& lighting) {
    osg::ref_ptr<osg::Group> layers = new osg::Group;
    const unsigned sunLayers = firstLampLayer(castingLamps(lighting, floor)) - 1;
    if (sunCasts(lighting, floor)) {
        const Vec3 sun = towardsSun(lighting);
        const Vec3 side = sun.cross(Vec3::UnitX()).normalized(), other = sun.cross(side);
        const float power = 0.5f / static_cast<float>(sunLayers);
        const float each = 1 - std::pow(1 - fullDepth(lighting, floor.normal()), 1.f / static_cast<float>(sunLayers));
        for (unsigned i = 0; i < sunLayers; ++i) {
            const double turn = 2 * std::numbers::pi * i / sunLayers + 0.3, reach = kSunRadius * (i % 2 ? 1.0 : 0.55);
            const Vec3 light = (sun + reach * (std::cos(turn) * side + std::sin(turn) * other)).normalized();
            if (floor.normal().dot(light) > 0.1)
                layers->addChild(makeSunLayer(floor, index, i, light, {each, power}, casters, look, lighting));
        }
        layers->addChild(
            makeLayer(floor, index, sunLayers, floor.normal(), {kContactDepth, 0, kContactTop}, casters, look, lighting));
    }
    return layers;
}

osg::ref_ptr<osg::Node> makeLampShadows(const FloorPlane& floor, unsigned index, osg::Group& casters, const SceneShading& look,
                                        const Lighting& lighting) {
    osg::ref_ptr<osg::Group> layers = new osg::Group;
    const std::vector<Lamp> lamps = castingLamps(lighting, floor);
    unsigned layer = firstLampLayer(lamps);
    for (const Lamp& lamp : lamps) layers->addChild(makeLampLayer(floor, index, layer++, lamp, lighting, casters, look));
    return layers;
}

} // namespace trundle
