#include "scene/speck.h"

#include <map>

#include <osg/LOD>

#include "scene/geom_nodes.h"
#include "scene/masks.h"

namespace trundle {
namespace {

constexpr float kSpeckPixels = 3.5f; // what is thin may fall between the pixels though its ball is larger than one

/// A shadow of one pixel is none.
class Speck final : public osg::LOD {
public:
    void traverse(osg::NodeVisitor& visitor) override {
        if (!castsShadows(visitor)) osg::LOD::traverse(visitor);
    }
};

/// By how much surface there is of it.
struct Mean {
    double area = 0;
    osg::Vec3d colour, glow;
    std::map<std::uint32_t, double> areaOfGeom;

    void add(const osg::Geometry& shapes) {
        const auto* points = dynamic_cast<const osg::Vec3Array*>(shapes.getVertexArray());
        const auto* colours = dynamic_cast<const osg::Vec4ubArray*>(shapes.getColorArray());
        const auto* glows = dynamic_cast<const osg::Vec4Array*>(shapes.getTexCoordArray(kGlowUnit));
        const auto* ranges = dynamic_cast<const GeomRanges*>(shapes.getUserData());
        const auto* triangles =
            shapes.getNumPrimitiveSets() ? dynamic_cast<const osg::DrawElementsUInt*>(shapes.getPrimitiveSet(0)) : nullptr;
        if (!points || !colours || !glows || !ranges || !triangles) return;
        for (std::size_t i = 0; i + 2 < triangles->size(); i += 3) {
            const unsigned a = (*triangles)[i], b = (*triangles)[i + 1], c = (*triangles)[i + 2];
            const double own = (((*points)[b] - (*points)[a]) ^ ((*points)[c] - (*points)[a])).length();
            const osg::Vec4ub& dye = (*colours)[a];
            const osg::Vec4& light = (*glows)[a];
            area += own;
            colour += osg::Vec3d(dye.r(), dye.g(), dye.b()) * own;
            glow += osg::Vec3d(light.x(), light.y(), light.z()) * own;
            areaOfGeom[ranges->geomOf(a)] += own;
        }
    }
};

template <class Array> osg::ref_ptr<Array> one(const typename Array::ElementDataType& value) {
    return new Array(osg::Array::BIND_PER_VERTEX, 1, &value);
}

} // namespace

osg::ref_ptr<osg::Node> makeSpeck(const osg::Group& geomNode, const Look& look) {
    Mean mean;
    for (unsigned i = 0; i < geomNode.getNumChildren(); ++i) {
        const osg::Node* child = geomNode.getChild(i);
        if (!(child->getNodeMask() & kMaskSolid)) continue; // one can see through it
        if (const auto* detail = child->asGroup(); detail && detail->getNumChildren() > 0) child = detail->getChild(0);
        if (const auto* shapes = dynamic_cast<const osg::Geometry*>(child)) mean.add(*shapes);
    }
    if (!(mean.area > 0)) return nullptr;
    const auto largest = std::max_element(mean.areaOfGeom.begin(), mean.areaOfGeom.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
    const osg::Vec3d dye = mean.colour / mean.area, light = mean.glow / mean.area;
    const auto byteOf = [](double value) { return static_cast<std::uint8_t>(std::lround(value)); };

    osg::ref_ptr<osg::Geometry> point = new osg::Geometry;
    point->setUseDisplayList(false);
    point->setUseVertexBufferObjects(true);
    const osg::BoundingSphere& ball = geomNode.getBound();
    const auto colour = one<osg::Vec4ubArray>(osg::Vec4ub(byteOf(dye.x()), byteOf(dye.y()), byteOf(dye.z()), 255));
    colour->setNormalize(true);
    point->setVertexArray(one<osg::Vec3Array>(ball.center()));
    point->setNormalArray(one<osg::Vec3Array>(osg::Vec3(0, 0, 1)));
    point->setColorArray(colour);
    point->setTexCoordArray(kGlowUnit, one<osg::Vec4Array>(osg::Vec4(light, 0)));
    point->setTexCoordArray(kLayerUnit, one<osg::FloatArray>(float(largest->first)));
    point->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, 0, 1));
    point->setStateSet(look.bodies);

    osg::ref_ptr<osg::LOD> speck = new Speck;
    speck->setRangeMode(osg::LOD::PIXEL_SIZE_ON_SCREEN);
    speck->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
    speck->setCenter(ball.center());
    speck->setRadius(ball.radius());
    speck->addChild(point, 0, kSpeckPixels);
    speck->setCullingActive(false); // else it and all above it would be left out for being small
    return speck;
}

} // namespace trundle
