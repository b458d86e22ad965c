#pragma once
// Where balls and wheels touch the triangles of a surface: at the points nearest to their centres. A point on an edge belongs to both
// triangles there, and none of them pushes along its own normal; the edge between a face that is touched and its neighbour is no edge.

#include <span>

#include "world/ode/collision/hull_on_mesh.h"
#include "world/wheel_contact.h"

namespace trundle {

/// Adds the contacts of a ball. `solid`: the inside of the surface is solid, so that a centre behind all of it is brought out; else
/// a triangle acts on its front side alone.
void ballOnTriangles(const Vec3& centre, double radius, std::span<const Triangle> triangles, bool solid,
                     std::vector<SurfaceContact>& contacts);

/// Of a cylinder about an axle, where its lateral surface or its rims touch: those of discs along it, at most a radius apart.
void cylinderOnTriangles(const WheelPose& cylinder, double halfLength, std::span<const Triangle> triangles,
                         std::vector<SurfaceContact>& contacts);

struct TreadContact : SurfaceContact {
    bool rolling = true; ///< on the tread; else the rim hits something from the side
};

/// Of a wheel, a cylinder about its axle: at the middle of its tread, and where only a rim touches, there. At most one contact of a
/// direction; what its ends lie on flush is not found.
void wheelOnTriangles(const WheelPose& wheel, double halfWidth, std::span<const Triangle> triangles,
                      std::vector<TreadContact>& contacts);

} // namespace trundle
