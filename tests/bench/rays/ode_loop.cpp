#include "bench/rays/ode_loop.h"

#include <cmath>

namespace raybench {

namespace {

/// Whether the ray meets a box before `range` (slabs).
bool meets(const Box3& box, const SingleRay& ray, double range) {
    double from = 0, to = range;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(ray.direction[k]) < 1e-300) {
            if (ray.origin[k] < box.lo[k] || ray.origin[k] > box.hi[k]) return false;
            continue;
        }
        double a = (box.lo[k] - ray.origin[k]) / ray.direction[k], b = (box.hi[k] - ray.origin[k]) / ray.direction[k];
        if (a > b) std::swap(a, b);
        from = std::max(from, a);
        to = std::min(to, b);
        if (from > to) return false;
    }
    return true;
}

} // namespace

OdeLoop::OdeLoop() : m_ray((dInitODE2(0), dAllocateODEDataForThread(dAllocateMaskAll), dCreateRay(nullptr, 1))) {
    dGeomRaySetClosestHit(m_ray, 1);
}

OdeLoop::~OdeLoop() {
    for (const Geom& g : m_geoms) {
        dGeomDestroy(g.id);
        if (g.mesh) dGeomTriMeshDataDestroy(g.mesh);
    }
    dGeomDestroy(m_ray);
}

void OdeLoop::add(const GeomSpec& spec, const Pose& pose, std::uint32_t actor) {
    Geom g;
    g.actor = actor;
    g.plane = spec.shape == GeomShape::Plane;
    if (spec.shape == GeomShape::Box) g.id = dCreateBox(nullptr, spec.size.x(), spec.size.y(), spec.size.z());
    else if (spec.shape == GeomShape::Sphere) g.id = dCreateSphere(nullptr, spec.radius);
    else if (spec.shape == GeomShape::Cylinder) g.id = dCreateCylinder(nullptr, spec.radius, spec.length);
    else if (g.plane) {
        const Vec3 n = pose.rotation * Vec3::UnitZ();
        g.id = dCreatePlane(nullptr, n.x(), n.y(), n.z(), n.dot(pose.position));
    } else {
        g.source = spec.mesh;
        g.triangles = std::make_shared<std::vector<dTriIndex>>();
        for (const auto& t : spec.mesh->triangles) g.triangles->insert(g.triangles->end(), t.begin(), t.end());
        g.mesh = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(g.mesh, spec.mesh->points.data(), 3 * sizeof(double),
                                    static_cast<int>(spec.mesh->points.size()), g.triangles->data(),
                                    static_cast<int>(g.triangles->size()), 3 * sizeof(dTriIndex));
        g.id = dCreateTriMesh(nullptr, g.mesh, nullptr, nullptr, nullptr);
    }
    if (actor == kNoGeom || m_actors.empty() || m_actors.back().index != actor)
        m_actors.push_back({m_geoms.size(), 0, actor, {}});
    m_geoms.push_back(std::move(g));
    m_actors.back().end = m_geoms.size();
    if (!m_geoms.back().plane) place(m_geoms.size() - 1, pose);
}

void OdeLoop::place(std::size_t geom, const Pose& pose) {
    const dQuaternion q = {pose.rotation.w(), pose.rotation.x(), pose.rotation.y(), pose.rotation.z()};
    dGeomSetPosition(m_geoms[geom].id, pose.position.x(), pose.position.y(), pose.position.z());
    dGeomSetQuaternion(m_geoms[geom].id, q);
    dReal box[6];
    dGeomGetAABB(m_geoms[geom].id, box);
    m_geoms[geom].box = {{box[0], box[2], box[4]}, {box[1], box[3], box[5]}};
}

void OdeLoop::updateBoxes() {
    for (Actor& actor : m_actors) {
        actor.box = m_geoms[actor.begin].box;
        for (std::size_t i = actor.begin + 1; i < actor.end; ++i) actor.box.cover(m_geoms[i].box);
    }
}

void OdeLoop::look(std::size_t geom, const SingleRay& ray, std::optional<SingleHit>& best) const {
    const double range = best ? best->distance : ray.range;
    dGeomRaySetLength(m_ray, range);
    dGeomRaySet(m_ray, ray.origin.x(), ray.origin.y(), ray.origin.z(), ray.direction.x(), ray.direction.y(), ray.direction.z());
    dContactGeom found;
    if (dCollide(m_ray, m_geoms[geom].id, 1, &found, sizeof found) == 0 || !(found.depth < range)) return;
    best = {found.depth, Vec3(found.normal[0], found.normal[1], found.normal[2]), static_cast<std::uint32_t>(geom)};
}

std::optional<SingleHit> OdeLoop::cast(const SingleRay& ray, std::uint32_t without) const {
    std::optional<SingleHit> best;
    for (const Actor& actor : m_actors) {
        if (actor.index == without && without != kNoGeom) continue;
        const bool plane = m_geoms[actor.begin].plane;
        if (!plane && !meets(actor.box, ray, best ? best->distance : ray.range)) continue;
        for (std::size_t i = actor.begin; i < actor.end; ++i)
            if (plane || meets(m_geoms[i].box, ray, best ? best->distance : ray.range)) look(i, ray, best);
    }
    return best;
}

} // namespace raybench
