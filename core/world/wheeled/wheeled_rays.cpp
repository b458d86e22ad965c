#include "world/wheeled/wheeled_rays.h"

#include <cmath>

namespace trundle {

namespace {

std::shared_ptr<const TriangleTree> treeOf(const TriangleMesh& mesh) {
    std::vector<std::array<Vec3, 3>> triangles;
    const auto at = [&](std::uint32_t corner) {
        return Vec3(mesh.points[corner][0], mesh.points[corner][1], mesh.points[corner][2]);
    };
    for (const auto& t : mesh.triangles) triangles.push_back({at(t[0]), at(t[1]), at(t[2])});
    return std::make_shared<TriangleTree>(triangles);
}

void makeMesh(const TriangleMesh& mesh, RayGeom& out) {
    out.shape.kind = RayShape::Mesh;
    out.tree = treeOf(mesh);
    for (const auto& p : mesh.points) {
        const Vec3 at(p[0], p[1], p[2]);
        out.half = out.half.cwiseMax(at.cwiseAbs());
        out.bound = std::max(out.bound, at.norm());
    }
}

} // namespace

RayGeom rayGeomOf(const GeomSpec& spec, const Pose& pose, std::uint32_t actor) {
    RayGeom out;
    out.centre = pose.position;
    out.axes = pose.rotation.toRotationMatrix();
    out.actor = actor;
    out.shape.radius = spec.radius;
    const double r = spec.radius, l = spec.length / 2;
    switch (spec.shape) {
    case GeomShape::Plane: out.shape.kind = RayShape::Plane; break;
    case GeomShape::Box:
        out.shape.kind = RayShape::Box;
        out.half = spec.size / 2;
        out.bound = out.half.norm();
        break;
    case GeomShape::Sphere:
        out.shape.kind = RayShape::Sphere;
        out.half = Vec3::Constant(r);
        out.bound = r;
        break;
    case GeomShape::Cylinder:
        out.shape.kind = RayShape::Cylinder;
        out.half = {r, r, l};
        out.bound = std::sqrt(r * r + l * l);
        break;
    case GeomShape::Capsule:
        out.shape.kind = RayShape::Capsule;
        out.half = {r, r, l + r};
        out.bound = l + r;
        break;
    default:
        if (spec.hull) makeMesh(*spec.hull, out);
        else if (spec.mesh) makeMesh(*spec.mesh, out);
    }
    for (int k = 0; k < 3; ++k) out.shape.half[k] = out.half[k];
    if (spec.shape == GeomShape::Capsule) out.shape.half[2] = l;
    return out;
}

void WheeledRays::place(RayScene& scene) const {
    while (scene.size() < m_objects.geoms.size()) scene.add(m_objects.geoms[scene.size()].ray);
    for (std::uint32_t i = 0; i < m_objects.geoms.size(); ++i) {
        const WheeledGeom& g = m_objects.geoms[i];
        if (g.body == kNoGeom) continue;
        const BodyState& state = m_objects.states[g.body];
        RayGeom& geom = scene.geom(i);
        geom.centre = state.position + state.rotation * g.ray.centre;
        geom.axes = state.rotation.toRotationMatrix() * g.ray.axes;
    }
}

} // namespace trundle
