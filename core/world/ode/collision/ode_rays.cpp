#include "world/ode/collision/ode_rays.h"

namespace trundle {

namespace {

RayShape::Kind kindOf(GeomShape shape) {
    switch (shape) {
    case GeomShape::Box: return RayShape::Box;
    case GeomShape::Sphere: return RayShape::Sphere;
    case GeomShape::Cylinder: return RayShape::Cylinder;
    case GeomShape::Capsule: return RayShape::Capsule;
    case GeomShape::Plane: return RayShape::Plane;
    case GeomShape::Convex: return RayShape::Hull;
    case GeomShape::Mesh: return RayShape::Mesh;
    case GeomShape::Heightfield: return RayShape::Heights;
    }
    return RayShape::Box;
}

std::shared_ptr<const TriangleTree> treeOf(const ShapeData& mesh) {
    std::vector<std::array<Vec3, 3>> triangles;
    const auto at = [&](std::size_t corner) { return Vec3(&mesh.points[3 * mesh.triangles[corner]]); };
    for (std::size_t t = 0; t + 2 < mesh.triangles.size(); t += 3) triangles.push_back({at(t), at(t + 1), at(t + 2)});
    return std::make_shared<TriangleTree>(triangles);
}

} // namespace

RayGeom OdeRays::geomOf(std::uint32_t index) const {
    const OdeGeom& g = m_objects.geoms[index];
    RayGeom geom;
    geom.shape.kind = kindOf(g.shape);
    geom.shape.radius = g.radius;
    for (int k = 0; k < 3; ++k) geom.shape.half[k] = g.half[k];
    if (g.shape == GeomShape::Capsule) geom.shape.half[2] -= g.radius;
    geom.centre = m_objects.centres[index];
    geom.axes = g.axes;
    geom.half = g.half;
    geom.bound = g.bound;
    geom.actor = g.actor;
    if (g.shape == GeomShape::Convex) {
        geom.shape.planes = g.data->planes.data();
        geom.shape.planeCount = static_cast<int>(g.data->planes.size() / 4);
    }
    if (g.shape == GeomShape::Mesh) geom.tree = treeOf(*g.data);
    if (g.shape == GeomShape::Heightfield)
        geom.heights = std::make_shared<HeightBlocks>(g.data->heightMap, 2 * g.half.x(), 2 * g.half.z(), g.radius);
    return geom;
}

void OdeRays::place(RayScene& scene) const {
    while (scene.size() < m_objects.geoms.size()) scene.add(geomOf(static_cast<std::uint32_t>(scene.size())));
    for (const OdeBody& body : m_objects.bodies)
        for (std::uint32_t i = body.geoms.begin; i < body.geoms.end; ++i) {
            RayGeom& geom = scene.geom(i);
            geom.centre = vec(body.p) + turn(body.r, m_objects.geoms[i].offset);
            geom.axes = m_objects.axesOf(m_objects.geoms[i]);
        }
}

} // namespace trundle
