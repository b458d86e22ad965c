#include "world/ode/collision/ray_caster.h"

#include <cmath>

#include "world/ode/collision/ode_height_ray.h"

namespace trundle {

namespace {

/// Whether the ray hits a box before `range` (slab method).
bool meets(const Box3& box, const Vec3& origin, const Vec3& direction, double range) {
    double from = 0, to = range;
    for (int k = 0; k < 3; ++k) {
        if (std::abs(direction[k]) < 1e-300) {
            if (origin[k] < box.lo[k] || origin[k] > box.hi[k]) return false;
            continue;
        }
        double a = (box.lo[k] - origin[k]) / direction[k], b = (box.hi[k] - origin[k]) / direction[k];
        if (a > b) std::swap(a, b);
        from = std::max(from, a);
        to = std::min(to, b);
        if (from > to) return false;
    }
    return true;
}

} // namespace

RayCaster::RayCaster(const OdeObjects& objects) : m_objects(objects), m_ray(dCreateRay(nullptr, 1)) {
    dGeomRaySetClosestHit(m_ray.get(), 1);
}

std::optional<RayHit> RayCaster::rayOnGeom(std::uint32_t index, const Vec3& origin, const Vec3& direction, double range) const {
    const OdeGeom& g = m_objects.geoms[index];
    if (g.shape == GeomShape::Heightfield && g.data) {
        const HeightRay ray{g.axes.transpose() * (origin - m_objects.centres[index]), g.axes.transpose() * direction, range};
        const auto hit = rayOnHeights(ray, *g.data->heightMap, 2 * g.half.x(), 2 * g.half.z(), g.radius);
        if (!hit) return {};
        return RayHit{hit->distance, g.axes * hit->normal, index};
    }
    dGeomRaySetLength(m_ray.get(), range);
    dGeomRaySet(m_ray.get(), origin.x(), origin.y(), origin.z(), direction.x(), direction.y(), direction.z());
    dContactGeom found;
    if (dCollide(m_ray.get(), g.id, 1, &found, sizeof found) == 0 || !(found.depth <= range)) return {};
    Vec3 normal = vec(found.normal);
    if (normal.dot(direction) > 0) normal = -normal;
    return RayHit{found.depth, normal, index};
}

std::optional<RayHit> RayCaster::ray(const SingleRay& ray, std::uint32_t without) const {
    const Vec3 &origin = ray.origin, &direction = ray.direction;
    const double range = ray.range;
    if (!origin.allFinite() || !direction.allFinite() || !(range > 0) || !std::isfinite(range)) return {};
    const double length = direction.norm();
    if (!(length > 1e-12)) return {};
    const Vec3 along = direction / length;
    std::optional<RayHit> best;
    const auto look = [&](std::uint32_t geom) {
        const auto hit = rayOnGeom(geom, origin, along, best ? best->distance : range);
        if (hit && (!best || hit->distance < best->distance)) best = hit;
    };
    const auto far = [&] { return best ? best->distance : range; };
    try {
        prepareThread();
        for (const GroundPlane& plane : m_objects.planes) look(plane.geom);
        for (const std::uint32_t geom : m_objects.statics)
            if (meets(m_objects.boxes[geom], origin, along, far())) look(geom);
        for (std::uint32_t a = 0; a < m_objects.actors.size(); ++a) {
            if (a == without || !meets(m_objects.actorBoxes[a], origin, along, far())) continue;
            for (std::uint32_t i = m_objects.actors[a].geoms.begin; i < m_objects.actors[a].geoms.end; ++i)
                if (meets(m_objects.boxes[i], origin, along, far())) look(i);
        }
    } catch (const OdeFault&) { return {}; }
    return best;
}

void RayCaster::castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const {
    std::vector<SingleRay> rays;
    for (const double up : fan.elevations)
        for (std::uint32_t k = 0; k < fan.count; ++k) {
            const double bearing = fan.firstBearing + k * fan.bearingStep;
            const Vec3 local(std::cos(up) * std::cos(bearing), std::cos(up) * std::sin(bearing), std::sin(up));
            rays.push_back({fan.origin, fan.axes * local, fan.range});
        }
    castRays(rays, without, hits);
}

void RayCaster::castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const {
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const auto hit = ray(rays[i], without);
        hits.distances[i] = hit ? hit->distance : rays[i].range;
        if (hits.geoms) hits.geoms[i] = hit ? hit->geom : kNoGeom;
        for (int k = 0; hits.normals && k < 3; ++k) hits.normals[3 * i + static_cast<std::size_t>(k)] = hit ? hit->normal[k] : 0;
    }
}

} // namespace trundle
