#pragma once
// How far a thing must go to be clear of another: exact for convex shapes, whatever way they are turned.

#include <limits>
#include <vector>

#include "scene/extents.h"

namespace trundle {

/// A convex piece of a geom in the world: points (or a rounded shape about a few), or all that is below a plane.
class ConvexPiece {
public:
    /// Of a geom whose body or static stands at `owner`: one piece, but for height maps and meshes that collide as meshes, which give
    /// their triangles, those near `about` only.
    [[nodiscard]] static std::vector<ConvexPiece> of(const GeomSpec& geom, const Pose& owner, const Bounds& about);

    [[nodiscard]] Vec3 support(const Vec3& direction) const; ///< the farthest point that way; not of a half-space
    [[nodiscard]] const Bounds& bounds() const { return m_bounds; } ///< empty: without end
    void move(const Vec3& by);

    /// m along a unit direction until this, which is inside `fixed`, is clear of it and touches it. Infinite where it never is.
    [[nodiscard]] double wayOut(const ConvexPiece& fixed, const Vec3& direction) const;
    /// Whether the two share more than their surfaces: by more than `depth` (m) whichever way one would leave.
    [[nodiscard]] bool isInside(const ConvexPiece& fixed, double depth) const;

private:
    Pose m_pose;
    std::vector<Vec3> m_points; // in the piece's frame
    double m_grown = 0;         // a ball about each point
    double m_radius = 0, m_half = 0; // of a cylinder, along its z; 0: none
    Vec3 m_normal = Vec3::Zero();    // of a half-space, whose edge goes through m_pose.position
    Bounds m_bounds;
    [[nodiscard]] bool isHalfSpace() const { return !m_normal.isZero(); }
};

} // namespace trundle
