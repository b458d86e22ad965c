#pragma once
// Ray casts against the shapes of the model: exact, and independent of graphics.

#include <vector>

#include "scene/queries/camera_view.h"
#include "scene/queries/object_index.h"

namespace trundle {

struct RayHit {
    ObjectRef geom; ///< a Geom or StaticGeom
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< unit vector on the side of the ray's origin
    double distance = 0;         ///< m from the ray's origin
};

/// The entry point of each visible geom on the ray, nearest first. Planes are hit from both sides.
[[nodiscard]] std::vector<RayHit> castRay(const ObjectIndex& objects, const BodyPoses& poses, const ViewRay& ray);

/// Number of colliding geoms between two points, each counted once, without those of two robots (given by index; other numbers
/// exclude nothing). The world uses the same count for WallLoss.
[[nodiscard]] int solidsBetween(const ObjectIndex& objects, const BodyPoses& poses, const Vec3& from, const Vec3& to,
                                std::size_t robot, std::size_t otherRobot);

} // namespace trundle
