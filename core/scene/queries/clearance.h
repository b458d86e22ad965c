#pragma once
// How far an object must move to be clear of another; exact for convex shapes in any orientation.

#include <limits>
#include <vector>

#include "scene/shapes/extents.h"

namespace trundle {

/// A convex piece of a geom in world coordinates: points (or a rounded shape around a few points), or a half-space.
class ConvexPiece {
public:
    /// The pieces of a geom whose body or static is at `owner` (X_WO): one piece, except for height maps and triangle meshes,
    /// which give one piece per triangle near `about`.
    [[nodiscard]] static std::vector<ConvexPiece> of(const GeomSpec& geom, const Pose& owner, const Bounds& about);

    [[nodiscard]] Vec3 support(const Vec3& direction) const;        ///< farthest point in that direction; not for half-spaces
    [[nodiscard]] const Bounds& bounds() const { return m_bounds; } ///< empty: unbounded
    void move(const Vec3& by);

    /// Distance (m) along a unit direction that moves this piece, which is inside `fixed`, until it touches `fixed` from outside.
    /// Infinite if it never leaves.
    [[nodiscard]] double exitDistance(const ConvexPiece& fixed, const Vec3& direction) const;
    /// True if the penetration depth exceeds `depth` (m) in every direction.
    [[nodiscard]] bool isInside(const ConvexPiece& fixed, double depth) const;

private:
    void takeShape(const GeomSpec& geom);
    [[nodiscard]] static std::vector<ConvexPiece> ofTriangles(const GeomSpec& geom, const Pose& owner, const Bounds& about);

    Pose m_pose;
    std::vector<Vec3> m_points;      // in the piece's frame
    double m_grown = 0;              // m, radius of a sphere around each point
    double m_radius = 0, m_half = 0; // m, cylinder along its z axis; 0: no cylinder
    Vec3 m_normal = Vec3::Zero();    // of a half-space; m_pose.position is on its surface
    Bounds m_bounds;
    [[nodiscard]] bool isHalfSpace() const { return !m_normal.isZero(); }
};

} // namespace trundle
