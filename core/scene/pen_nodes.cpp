#include "scene/pen_nodes.h"

#include <cmath>
#include <numbers>

#include "scene/nodes/geom_nodes.h"
#include "scene/nodes/masks.h"

namespace trundle {
namespace {

constexpr double kAbove = 1e-3; // m, so that the floor does not hide it
constexpr int kRound = 8;       // corners of an end

void addRound(TriangleMesh& mesh, const Vec3& at, double radius) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int i = 0; i < kRound; ++i) {
        const double angle = 2 * std::numbers::pi * i / kRound;
        mesh.points.push_back({at.x() + radius * std::cos(angle), at.y() + radius * std::sin(angle), at.z()});
    }
    for (std::uint32_t i = 2; i < kRound; ++i) mesh.triangles.push_back({first, first + i - 1, first + i});
}

void addSegment(TriangleMesh& mesh, const Vec3& from, const Vec3& to, double radius) {
    const Vec3 way = to - from, side = Vec3(-way.y(), way.x(), 0).normalized() * radius;
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Vec3& p : {Vec3(from - side), Vec3(to - side), Vec3(to + side), Vec3(from + side)})
        mesh.points.push_back({p.x(), p.y(), p.z()});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

} // namespace

TriangleMesh ribbonOf(const PenLine& line) {
    TriangleMesh mesh;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec3 at = line.points[i].at + kAbove * Vec3::UnitZ();
        addRound(mesh, at, line.width / 2);
        if (i > 0 && !line.points[i].begins) addSegment(mesh, line.points[i - 1].at + kAbove * Vec3::UnitZ(), at, line.width / 2);
    }
    return mesh;
}

PenNodes::PenNodes(osg::Group& scene) {
    m_nodes->setNodeMask(kMaskFloor);
    scene.addChild(m_nodes);
}

void PenNodes::set(const std::vector<PenLine>& lines, const SceneShading& look, Pictures& pictures) {
    m_nodes->removeChildren(0, m_nodes->getNumChildren());
    for (const PenLine& line : lines) {
        if (line.points.empty()) continue;
        GeomSpec geom;
        geom.shape = GeomShape::Mesh;
        geom.mesh = std::make_shared<const TriangleMesh>(ribbonOf(line));
        geom.collide = false;
        MaterialSpec ink;
        ink.colour = line.colour;
        const osg::ref_ptr<osg::Group> node = makeGeomNode(std::span(&geom, 1), {ink}, {}, look, pictures);
        if (auto* drawn = dynamic_cast<GeomNode*>(node.get())) drawn->caster = nullptr;
        m_nodes->addChild(node);
    }
}

} // namespace trundle
