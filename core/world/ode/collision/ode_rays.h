#pragma once
// Rays against what is in the engine; trees over meshes are made at the first cast of the run.

#include "world/ode/objects/ode_objects.h"
#include "world/rays/ray_targets.h"

namespace trundle {

class OdeRays final : public RayTargets {
public:
    /// The objects outlive this.
    explicit OdeRays(const OdeObjects& objects, const RayKernel& kernel = rayKernel()) : RayTargets(kernel), m_objects(objects) {}

private:
    void place(RayScene& scene) const override;
    [[nodiscard]] RayGeom geomOf(std::uint32_t index) const;

    const OdeObjects& m_objects;
};

} // namespace trundle
