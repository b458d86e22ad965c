#pragma once
// What a geom is for others on level ground: a convex shape over x and y between two heights.

#include <span>
#include <string>
#include <vector>

#include "base/result.h"
#include "model/body_spec.h"

namespace trundle {

using Vec2 = Eigen::Vector2d;

/// A pose over x and y: where, and the cosine and sine of the heading.
struct PlanarPose {
    Vec2 at = Vec2::Zero();
    double c = 1, s = 0;

    [[nodiscard]] Vec2 turn(const Vec2& v) const { return {c * v.x() - s * v.y(), s * v.x() + c * v.y()}; }
    [[nodiscard]] Vec2 turnBack(const Vec2& v) const { return {c * v.x() + s * v.y(), c * v.y() - s * v.x()}; }
};

inline constexpr std::size_t kMostCorners = 64;

struct PlanarShape {
    Vec2 centre = Vec2::Zero(); ///< in the frame of its owner
    double radius = 0;          ///< of a circle; 0: a polygon
    std::vector<Vec2> corners,
        outwards;             ///< of a polygon, counter-clockwise, at most kMostCorners; normals of the edges from each corner on
    double bound = 0;         ///< farthest point from the centre
    double low = 0, high = 0; ///< heights, m
    bool upright = false;     ///< its sides are the same at all heights
    std::uint32_t surface = 0;

    [[nodiscard]] bool isCircle() const { return corners.empty(); }
};

/// Of a geom at a pose in the frame of its owner, z upwards. What leans is projected: its footprint is all that is below it. Error: a shape
/// that has none (planes, height maps, open meshes).
[[nodiscard]] Result<PlanarShape> planarShapeOf(const GeomSpec& geom, const Pose& pose);

/// Adds the corners of a geom at a pose that are at most that high, over x and y; of a round one those of a prism inside it.
void addPointsBelow(const GeomSpec& geom, const Pose& pose, double height, std::vector<Vec2>& to);
/// Counter-clockwise, without points on its edges.
[[nodiscard]] std::vector<Vec2> convexHullOf(std::vector<Vec2> points);

/// Where two footprints touch or nearly do. Heights are not looked at.
struct PlanarTouch {
    int count = 0;           ///< of the points, at most 2
    Vec2 normal{1, 0};       ///< from the first to the second
    Vec2 points[2];          ///< world
    double gaps[2] = {0, 0}; ///< m, negative where they overlap
};
/// Points with a gap of at most `margin`. Method: separating axes, then clipping of the facing edges (E. Catto, Contact Manifolds, GDC 2007).
[[nodiscard]] PlanarTouch touchOf(const PlanarShape& a, const PlanarPose& atA, const PlanarShape& b, const PlanarPose& atB,
                                  double margin);

} // namespace trundle
