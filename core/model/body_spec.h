#pragma once
// Bodies, their geoms and their mass, in SI units, immutable once resolved.

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
    Pose pose;                ///< in its body (in its config, for a static)
    Vec3 size = Vec3::Zero(); ///< Box: full lengths; Heightfield: x, y, height of white
    double radius = 0;
    double length = 0;                        ///< along the geom's z
    std::string file;                         ///< resolved path, or empty
    std::shared_ptr<const TriangleMesh> mesh; ///< Mesh, Convex (hull); scale applied
    /// Where collideAsHull: the convex hull of mesh, closed, seen from outside counter-clockwise.
    std::shared_ptr<const TriangleMesh> hull;
    std::shared_ptr<const HeightMap> heightMap; ///< Heightfield
    bool collideAsHull = false;                 ///< Mesh and Convex on a body: the convex hull collides
    std::optional<double> mass;                 ///< kg
    std::optional<double> density;              ///< kg/m^3
    std::uint32_t material = 0;                 ///< index into ExperimentSpec::materials
    std::uint32_t surface = 0;                  ///< index into ExperimentSpec::surfaces
    bool collide = true, visible = true;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< where a message about the geom points
};

/// Inertia about the centre of mass, in the body's axes.
struct MassProperties {
    double mass = 0; ///< kg, > 0
    Vec3 centre = Vec3::Zero();
    Mat3 inertia = Mat3::Identity(); ///< kg m^2, positive definite, triangle inequality holds
};

struct BodySpec {
    std::string name;
    Pose pose; ///< in the config frame
    std::vector<GeomSpec> geoms;
    MassProperties mass;
    SourceRange range;     ///< the whole block
    SourceRange nameRange; ///< where a message about the body points
};

} // namespace trundle
