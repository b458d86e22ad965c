#pragma once
// Triangles with normals for every shape of a geom, in the geom's own frame. Knows nothing of OSG.

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "base/triangle_mesh.h"
#include "model/body_spec.h"

namespace trundle {

struct ShapeMesh {
    std::vector<Eigen::Vector3f> points, normals; ///< same length
    std::vector<std::uint32_t> indices;           ///< three for each triangle, counter-clockwise from outside
    std::vector<std::uint32_t> sources;           ///< of a mesh: which of its triangles each one is; else empty

    /// Returns its index.
    std::uint32_t addPoint(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);
    /// Winds the triangle so that it faces the way its normals do.
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
};

/// How finely round shapes are cut, and whether edges of boxes catch the light.
struct Fineness {
    int segments = 16;
    bool bevel = true;
    /// Pixels to a metre where it is seen nearest. Shapes that are small there need fewer segments; 0: all have the same.
    double pixelsPerMetre = 0;
};

/// So many that the straight pieces leave the circle by half a pixel at most, and an even number of them.
[[nodiscard]] int segmentsFor(double radius, const Fineness& fineness);

[[nodiscard]] ShapeMesh boxMesh(const Eigen::Vector3f& size, bool bevel);
[[nodiscard]] ShapeMesh sphereMesh(float radius, int segments);
/// Closed by flat caps; along z.
[[nodiscard]] ShapeMesh cylinderMesh(float radius, float length, int segments);
/// `length` is that of the cylindrical part; along z.
[[nodiscard]] ShapeMesh capsuleMesh(float radius, float length, int segments);
/// Corners are smooth where faces meet at less than the crease angle. Triangles that are no triangles are left out.
[[nodiscard]] ShapeMesh smoothedMesh(const TriangleMesh& mesh);
/// The same surface with one point at each place and no normals: all that a shadow shows of it.
[[nodiscard]] ShapeMesh bareMesh(const TriangleMesh& mesh);
[[nodiscard]] ShapeMesh bareMesh(const ShapeMesh& mesh);
/// Black at z = 0, the top row at +y. Very large maps are drawn by every n-th sample.
[[nodiscard]] ShapeMesh heightfieldMesh(const HeightMap& map, const Eigen::Vector3f& size);

/// The shape of a geom; a small marker cube where its mesh or picture is missing; nothing for a Plane, which is drawn as a
/// floor, and for sizes that cannot be drawn.
[[nodiscard]] ShapeMesh shapeOf(const GeomSpec& geom, Fineness fineness);
/// The same without edges that catch the light, as bareMesh().
[[nodiscard]] ShapeMesh bareShapeOf(const GeomSpec& geom, Fineness fineness);
/// True where the mesh or height map of the geom is missing.
[[nodiscard]] bool isPlaceholder(const GeomSpec& geom);
/// A mesh whose colours and pictures are those of its own file: the text names no material for it.
[[nodiscard]] bool bringsItsLook(const GeomSpec& geom);

} // namespace trundle
