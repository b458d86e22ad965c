#include "scene/nodes/point_impostor.h"

#include <map>

#include <osg/LOD>

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/masks.h"

namespace trundle {
namespace {

constexpr float kImpostorPixels = 3.5f; // above 1: a thin object can fall between pixels although its bounding sphere is larger

/// Casts no shadow, since it is only one pixel.
class PointImpostor final : public osg::LOD {
public:
    void traverse(osg::NodeVisitor& visitor) override {
        if (!castsShadows(visitor)) osg::LOD::traverse(visitor);
    }
};

/// Mean colour weighted by surface area.
struct MeanColour {
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

osg::ref_ptr<osg::Node> makePointImpostor(const osg::Group& geomNode, const SceneShading& look) {
    MeanColour mean;
    for (unsigned i = 0; i < geomNode.getNumChildren(); ++i) {
        const osg::Node* child = geomNode.getChild(i);
        if (!(child->getNodeMask() & kMaskSolid)) continue; // transparent
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

    osg::ref_ptr<osg::LOD> impostor = new PointImpostor;
    impostor->setRangeMode(osg::LOD::PIXEL_SIZE_ON_SCREEN);
    impostor->setCenterMode(osg::LOD::USER_DEFINED_CENTER);
    impostor->setCenter(ball.center());
    impostor->setRadius(ball.radius());
    impostor->addChild(point, 0, kImpostorPixels);
    impostor->setCullingActive(false); // otherwise OSG's small-feature culling would drop it and its parents
    return impostor;
}

} // namespace trundle
