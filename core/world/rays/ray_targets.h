#pragma once
// What rays can hit in an engine. The scene for rays takes the poses over at the first cast of a tick, so that a run in which no device
// casts does not pay for it.

#include "base/on_demand.h"
#include "world/rays/ray_scene.h"

namespace trundle {

/// With the poses after the last step. Several threads may cast at the same time. Geoms of the actor `without` (an index, kNoGeom for
/// none) are ignored.
class RayTargets {
public:
    explicit RayTargets(const RayKernel& kernel = rayKernel()) : m_scene(kernel) {}
    RayTargets(const RayTargets&) = delete;
    RayTargets& operator=(const RayTargets&) = delete;
    virtual ~RayTargets() = default;

    /// Bodies have moved, or something was added; while nothing is cast.
    void markMoved() { m_update.markDue(); }

    /// Nothing for what is no ray.
    [[nodiscard]] std::optional<SingleHit> ray(const SingleRay& ray, std::uint32_t without) const;
    void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const { scene().castFan(fan, without, hits); }
    void castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const;
    /// How often poses were taken over for casts: once in a tick with casts.
    [[nodiscard]] std::uint64_t updates() const { return m_updates; }

private:
    /// Adds the geoms that the scene lacks, and moves those of bodies.
    virtual void place(RayScene& scene) const = 0;
    [[nodiscard]] const RayScene& scene() const;

    mutable RayScene m_scene;
    mutable OnDemand m_update;
    mutable std::uint64_t m_updates = 0;
};

} // namespace trundle
