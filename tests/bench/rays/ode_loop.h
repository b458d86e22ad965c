#pragma once
// Rays as a loop over ODE's geoms, one ray at a time: what Trundle did before fans, and what a simulator on ODE does without any search
// structure but bounding boxes.
#include <memory>
#include <vector>

#include <ode/ode.h>

#include "model/body_spec.h"
#include "world/broad_phase.h"
#include "world/rays/ray_query.h"

namespace raybench {

using namespace trundle;

class OdeLoop {
public:
    OdeLoop();
    ~OdeLoop();
    OdeLoop(const OdeLoop&) = delete;
    OdeLoop& operator=(const OdeLoop&) = delete;

    /// Geoms of one actor are added one after the other.
    void add(const GeomSpec& spec, const Pose& pose, std::uint32_t actor);
    void place(std::size_t geom, const Pose& pose);
    /// Of actors, after geoms were placed.
    void updateBoxes();
    [[nodiscard]] std::optional<SingleHit> cast(const SingleRay& ray, std::uint32_t without) const;

private:
    struct Geom {
        dGeomID id = nullptr;
        std::uint32_t actor = kNoGeom;
        bool plane = false;
        Box3 box;
        dTriMeshDataID mesh = nullptr;
        std::shared_ptr<std::vector<dTriIndex>> triangles;
        std::shared_ptr<const TriangleMesh> source;
    };
    struct Actor {
        std::size_t begin = 0, end = 0;
        std::uint32_t index = kNoGeom;
        Box3 box;
    };
    void look(std::size_t geom, const SingleRay& ray, std::optional<SingleHit>& best) const;

    dGeomID m_ray;
    std::vector<Geom> m_geoms;
    std::vector<Actor> m_actors; ///< scenery: one for each geom
};

} // namespace raybench
