#pragma once
// Rays against what is in the wheeled engine; poses are taken over at the first cast of a tick.

#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// Of a geom at a pose in the frame of its owner.
[[nodiscard]] RayGeom rayGeomOf(const GeomSpec& spec, const Pose& pose, std::uint32_t actor);

class WheeledRays final : public RayTargets {
public:
    explicit WheeledRays(const WheeledObjects& objects) : m_objects(objects) {}

    void markMoved() { m_moved = true; }
    [[nodiscard]] std::optional<SingleHit> ray(const SingleRay& ray, std::uint32_t without) const override;
    void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const override;
    void castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const override;
    [[nodiscard]] std::uint64_t updates() const override { return m_updates; }

private:
    void update() const;

    const WheeledObjects& m_objects;
    mutable RayScene m_scene;
    mutable bool m_moved = true;
    mutable std::uint64_t m_updates = 0;
};

} // namespace trundle
