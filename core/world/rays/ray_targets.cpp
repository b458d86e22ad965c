#include "world/rays/ray_targets.h"

#include <cmath>

namespace trundle {

const RayScene& RayTargets::scene() const {
    m_update.ensure([this] {
        ++m_updates;
        place(m_scene);
        m_scene.update();
    });
    return m_scene;
}

std::optional<SingleHit> RayTargets::ray(const SingleRay& ray, std::uint32_t without) const {
    const double length = ray.direction.norm();
    if (!ray.origin.allFinite() || !std::isfinite(length) || !(length > 1e-12) || !(ray.range > 0) || !std::isfinite(ray.range))
        return {};
    SingleHit hit;
    double normal[3];
    scene().castRay({ray.origin, ray.direction / length, ray.range}, without, {&hit.distance, &hit.geom, normal});
    hit.normal = Vec3(normal);
    return hit.geom == kNoGeom ? std::nullopt : std::optional(hit);
}

void RayTargets::castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const {
    const RayScene& targets = scene();
    for (std::size_t i = 0; i < rays.size(); ++i)
        targets.castRay(
            rays[i], without,
            {hits.distances + i, hits.geoms ? hits.geoms + i : nullptr, hits.normals ? hits.normals + 3 * i : nullptr});
}

} // namespace trundle
