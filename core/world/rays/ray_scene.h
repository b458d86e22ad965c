#pragma once
// The geoms of a world as rays see them, and the casts.
//
// Needs: geoms by their numbers in the engine, with their poses; update() after they moved.
// Assumes: unit directions, orthonormal axes, no update during casts, of which there may be several at the same time.
// Method: candidates from a grid of bounding balls, then closed forms for all beams of a fan together (ray_kernel.h). Of equally near
//   geoms the one with the lower number is hit, so that the result depends on nothing but the geoms: not on the grid, the order of the
//   candidates or the processor.
// Data: one RayGeom per geom. Small geoms are in grids, what stays and what moves apart; large ones, planes, meshes and height maps are
//   in lists.

#include <memory>
#include <vector>

#include "world/rays/centre_grid.h"
#include "world/rays/height_blocks.h"
#include "world/rays/ray_kernel.h"
#include "world/rays/ray_query.h"
#include "world/rays/triangle_tree.h"

namespace trundle {

/// A geom; `half` of its shape is about its centre, in its axes. For a plane the centre is a point of it and z is its normal.
struct RayGeom {
    RayShape shape;
    Vec3 centre = Vec3::Zero();
    Mat3 axes = Mat3::Identity();
    Vec3 half = Vec3::Zero();      ///< of its bounding box
    double bound = 0;              ///< radius of its bounding ball
    std::uint32_t actor = kNoGeom; ///< kNoGeom: of the scenery, which stays
    std::shared_ptr<const TriangleTree> tree;
    std::shared_ptr<const HeightBlocks> heights;
};

class RayScene {
public:
    /// Balls are filed in cells of this many metres; only the time depends on it.
    explicit RayScene(const RayKernel& kernel = rayKernel(), double cell = 1);

    /// The next geom, in the engine's order.
    void add(RayGeom geom);
    [[nodiscard]] std::size_t size() const { return m_geoms.size(); }
    [[nodiscard]] RayGeom& geom(std::uint32_t index) { return m_geoms[index]; }
    /// After geoms were added or moved, before the next cast.
    void update();

    void castFan(const RayFan& fan, std::uint32_t without, const RayHits& hits) const;
    void castRay(const SingleRay& ray, std::uint32_t without, const RayHits& hits) const;

private:
    struct FanCast; ///< ray_scene_fan.cpp

    [[nodiscard]] GeomBall ballOf(std::uint32_t geom) const;
    [[nodiscard]] LocalBeams local(const RayGeom& geom, const Vec3& origin, const Vec3& a, const Vec3& b, const Vec3& c) const;
    void cast(std::uint32_t geom, const BeamRow& row, const LocalBeams& beams, const RayRoots& roots) const {
        const RayShape& shape = m_geoms[geom].shape;
        m_kernel.cast[shape.kind](row, beams, shape, geom, roots);
    }
    /// Of what is hit at origin + way, against it; zeros where nothing is hit. `part` as in BeamRow.
    void writeNormal(double geom, double part, const Vec3& origin, const Vec3& way, double* out) const;

    const RayKernel& m_kernel;
    std::vector<RayGeom> m_geoms;
    std::size_t m_filed = 0; ///< geoms that are in the lists
    std::vector<std::uint32_t> m_planes, m_meshes, m_movingSmall;
    std::vector<GeomBall> m_balls, m_large; ///< of m_movingSmall; that are tested by every cast
    CentreGrid m_still, m_moving;
};

} // namespace trundle
