#pragma once
// Rays against what is in the engine. The scene for rays takes the poses over at the first cast of a tick, so that a run in which no device
// casts does not pay for it; trees over meshes are made at the first cast of the run.

#include "world/ode/objects/ode_objects.h"
#include "world/rays/ray_scene.h"

namespace trundle {

class OdeRays final : public RayTargets {
public:
    /// The objects outlive this.
    explicit OdeRays(const OdeObjects& objects, const RayKernel& kernel = rayKernel()) : m_objects(objects), m_scene(kernel) {}

    /// Bodies have moved, or something was added.
    void markMoved() { m_moved = true; }

    [[nodiscard]] std::optional<SingleHit> ray(const SingleRay& ray, std::uint32_t without) const override;
    void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const override;
    void castRays(std::span<const SingleRay> rays, std::uint32_t without, const RayHits& hits) const override;
    [[nodiscard]] std::uint64_t updates() const override { return m_updates; }

private:
    void update() const;
    [[nodiscard]] RayGeom geomOf(std::uint32_t index) const;

    const OdeObjects& m_objects;
    mutable RayScene m_scene;
    mutable bool m_moved = true;
    mutable std::uint64_t m_updates = 0;
};

} // namespace trundle
