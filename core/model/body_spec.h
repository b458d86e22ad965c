#pragma once
// Bodies, geoms and mass properties. Immutable, SI units.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <trundle/geometry.h>

#include "base/source_range.h"
#include "base/triangle_mesh.h"

namespace trundle {

enum class GeomShape { Box, Sphere, Cylinder, Capsule, Plane, Convex, Heightfield, Mesh };

struct GeomSpec {
    std::string name;
    GeomShape shape = GeomShape::Box;
    Pose pose;                ///< in the body frame (in the config frame for a static)
    Vec3 size = Vec3::Zero(); ///< Box: full lengths; Heightfield: x, y, height of white; m
    double radius = 0;
    double length = 0;                        ///< along the geom's z axis, m
    std::string file;                         ///< resolved path, or empty
    std::shared_ptr<const TriangleMesh> mesh; ///< for Mesh and Convex; scale applied
    /// For collideAsHull: the closed convex hull of mesh, triangles counter-clockwise seen from outside.
    std::shared_ptr<const TriangleMesh> hull;
    std::shared_ptr<const HeightMap> heightMap; ///< for Heightfield
    bool collideAsHull = false;                 ///< Mesh and Convex on a body: collides as its convex hull
    std::optional<double> mass;                 ///< kg
    std::optional<double> density;              ///< kg/m^3
    std::uint32_t material = 0;                 ///< index into ExperimentSpec::materials
    std::uint32_t surface = 0;                  ///< index into ExperimentSpec::surfaces
    bool collide = true, visible = true;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< for diagnostics about the geom
};

/// Mass, centre of mass, and inertia about the centre of mass along the body's axes.
struct MassProperties {
    double mass = 0; ///< kg, > 0
    Vec3 centre = Vec3::Zero();
    Mat3 inertia = Mat3::Identity(); ///< kg m^2, positive definite, triangle inequality holds
};

struct BodySpec {
    std::string name;
    Pose pose; ///< in the config frame
    std::vector<GeomSpec> geoms;
    MassProperties mass;   ///< zero if it is fixed
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< for diagnostics about the body
    bool isFixed = false;  ///< it does not move: the frame of a Static, without geoms
};

} // namespace trundle
