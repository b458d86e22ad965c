#pragma once
// Ray casts. Method: candidates are the actors and statics whose box is hit, then their geoms exactly. With a few thousand boxes at most,
// a linear search is fast enough.

#include <optional>

#include "world/ode/objects/ode_objects.h"
#include "world/ode/objects/ode_world.h"

namespace trundle {

class RayCaster final : public RayTargets {
public:
    /// The objects outlive this.
    explicit RayCaster(const OdeObjects& objects);

    [[nodiscard]] std::optional<RayHit> ray(const SingleRay& ray, std::uint32_t without) const override;
    void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const override;
    void castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const override;

private:
    [[nodiscard]] std::optional<RayHit> rayOnGeom(std::uint32_t geom, const Vec3& origin, const Vec3& direction,
                                                  double range) const;

    const OdeObjects& m_objects;
    OwnedGeom m_ray;
};

} // namespace trundle
