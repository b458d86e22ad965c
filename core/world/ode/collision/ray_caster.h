#pragma once
// Ray casts. Method: candidates are the actors and statics whose box is hit, then their geoms exactly. With a few thousand boxes at most,
// a linear search is fast enough.

#include <optional>

#include "world/ode/objects/ode_objects.h"
#include "world/ode/objects/ode_world.h"

namespace trundle {

class RayCaster {
public:
    /// The objects outlive this.
    explicit RayCaster(const OdeObjects& objects);

    /// Nearest hit along `direction` within `range` (m); geoms of the actor `without` are ignored. Nothing for what is no direction.
    [[nodiscard]] std::optional<RayHit> cast(const Vec3& origin, const Vec3& direction, double range, ActorHandle without) const;

private:
    [[nodiscard]] std::optional<RayHit> rayOnGeom(std::uint32_t geom, const Vec3& origin, const Vec3& direction,
                                                  double range) const;

    const OdeObjects& m_objects;
    OwnedGeom m_ray;
};

} // namespace trundle
