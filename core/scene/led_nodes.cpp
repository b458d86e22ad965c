#include "scene/led_nodes.h"

#include <cmath>

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/osg_types.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

constexpr int kLensSegments = 12;
constexpr float kMilk = 0.35f, kOwnShare = 0.3f; // of a dark lens: white, and its own colour

/// Is seen, but casts no shadow and cannot be picked: a click selects what is behind it.
class LensNode final : public osg::MatrixTransform {
public:
    explicit LensNode(const osg::Matrix& matrix) : osg::MatrixTransform(matrix) {
        setCullingActive(false); // a lens smaller than a pixel is still seen
    }
    void traverse(osg::NodeVisitor& visitor) override {
        const bool draws = visitor.getVisitorType() != osg::NodeVisitor::INTERSECTION_VISITOR;
        if (draws && !castsShadows(visitor)) osg::MatrixTransform::traverse(visitor);
    }
};

/// A sphere with a point at each end of its axes, so that a distant one shines in one pixel.
osg::ref_ptr<osg::Geometry> lensShape(float radius, const SceneShading& look) {
    const ShapeMesh mesh = sphereMesh(radius, kLensSegments);
    osg::ref_ptr<osg::Vec3Array> points = new osg::Vec3Array, normals = new osg::Vec3Array;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        points->push_back({mesh.points[i].x(), mesh.points[i].y(), mesh.points[i].z()});
        normals->push_back({mesh.normals[i].x(), mesh.normals[i].y(), mesh.normals[i].z()});
    }
    const auto sphere = static_cast<int>(points->size());
    for (const osg::Vec3& way : {osg::Vec3(1, 0, 0), {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}}) {
        points->push_back(way * radius);
        normals->push_back(way);
    }
    osg::ref_ptr<osg::Vec4ubArray> colours = new osg::Vec4ubArray(osg::Array::BIND_PER_VERTEX, points->size());
    colours->setNormalize(true);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setUseDisplayList(false);
    geometry->setUseVertexBufferObjects(true);
    geometry->setDataVariance(osg::Object::DYNAMIC);
    geometry->setVertexArray(points);
    geometry->setNormalArray(normals, osg::Array::BIND_PER_VERTEX);
    geometry->setColorArray(colours, osg::Array::BIND_PER_VERTEX);
    geometry->setTexCoordArray(kGlowUnit, new osg::Vec4Array(osg::Array::BIND_PER_VERTEX, points->size()));
    geometry->setTexCoordArray(kLayerUnit, new osg::FloatArray(osg::Array::BIND_PER_VERTEX, points->size()));
    geometry->addPrimitiveSet(new osg::DrawElementsUInt(GL_TRIANGLES, mesh.indices.begin(), mesh.indices.end()));
    geometry->addPrimitiveSet(new osg::DrawArrays(GL_POINTS, sphere, 6));
    geometry->setStateSet(look.bodies);
    return geometry;
}

} // namespace

void LedNodes::make(const std::vector<LedModel>& leds, std::span<const osg::ref_ptr<osg::MatrixTransform>> bodies,
                    const SceneShading& look) {
    for (const LedModel& led : leds) {
        Lens& lens = m_lenses.emplace_back();
        lens.own = led.colour;
        lens.shown = led.atStart;
        if (!(led.diameter > 0) || led.body >= bodies.size() || !led.mounting.position.allFinite()) continue;
        lens.shape = lensShape(static_cast<float>(led.diameter / 2), look);
        paint(lens);
        osg::ref_ptr<LensNode> node = new LensNode(toOsg(led.mounting));
        node->addChild(lens.shape);
        bodies[led.body]->addChild(node);
    }
}

void LedNodes::set(std::span<const LedColour> colours) {
    if (colours.size() != m_lenses.size()) return;
    for (std::size_t i = 0; i < colours.size(); ++i) {
        if (colours[i] == m_lenses[i].shown) continue;
        m_lenses[i].shown = colours[i];
        if (m_lenses[i].shape) paint(m_lenses[i]);
    }
}

/// One that shines has its colour and nothing else; a dark one is a milky plastic with a hint of it.
void LedNodes::paint(const Lens& lens) {
    const bool shines = lens.shown != LedColour{};
    const auto byteOf = [](float share) { return static_cast<std::uint8_t>(std::lround(255 * share)); };
    osg::Vec4ub colour(0, 0, 0, 255);
    for (int k = 0; k < 3 && !shines; ++k) colour[k] = byteOf(kMilk + kOwnShare * lens.own[static_cast<std::size_t>(k)]);
    auto* colours = static_cast<osg::Vec4ubArray*>(lens.shape->getColorArray());
    auto* glows = static_cast<osg::Vec4Array*>(lens.shape->getTexCoordArray(kGlowUnit));
    std::fill(colours->begin(), colours->end(), colour);
    std::fill(glows->begin(), glows->end(), osg::Vec4(lens.shown[0], lens.shown[1], lens.shown[2], 0));
    colours->dirty();
    glows->dirty();
}

} // namespace trundle
