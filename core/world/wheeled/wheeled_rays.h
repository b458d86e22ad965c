#pragma once
// Rays against what is in the wheeled engine.

#include "world/rays/ray_targets.h"
#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// Of a geom at a pose in the frame of its owner.
[[nodiscard]] RayGeom rayGeomOf(const GeomSpec& spec, const Pose& pose, std::uint32_t actor);

class WheeledRays final : public RayTargets {
public:
    explicit WheeledRays(const WheeledObjects& objects) : m_objects(objects) {}

private:
    void place(RayScene& scene) const override;

    const WheeledObjects& m_objects;
};

} // namespace trundle
