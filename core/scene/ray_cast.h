#pragma once
// What lies along a ray, computed from the shapes themselves: exact, with no graphics, and at once.

#include <vector>

#include "scene/object_index.h"
#include "scene/view.h"

namespace trundle {

struct RayHit {
    ObjectRef geom; ///< a Geom or StaticGeom
    Vec3 point = Vec3::Zero();
    Vec3 normal = Vec3::UnitZ(); ///< unit, towards where the ray comes from
    double distance = 0;         ///< m from the start of the ray
};

/// Where the ray enters each visible geom, nearest first. Planes are hit from both sides.
[[nodiscard]] std::vector<RayHit> castRay(const ObjectIndex& objects, const BodyPoses& poses, const ViewRay& ray);

/// Geoms that collide on the way between two points, each once, without those of two robots (by their numbers; others name none): what
/// a world counts for WallLoss.
[[nodiscard]] int solidsBetween(const ObjectIndex& objects, const BodyPoses& poses, const Vec3& from, const Vec3& to,
                                std::size_t robot, std::size_t otherRobot);

} // namespace trundle
