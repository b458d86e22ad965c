#pragma once
// Triangles with normals for every shape of a geom, in the geom's own frame. Independent of OSG.

#include <cstdint>
#include <vector>

#include <Eigen/Core>

#include "base/triangle_mesh.h"
#include "model/body_spec.h"

namespace trundle {

struct ShapeMesh {
    std::vector<Eigen::Vector3f> points, normals; ///< same length
    std::vector<std::uint32_t> indices;           ///< three per triangle, counter-clockwise seen from outside
    std::vector<std::uint32_t> sources;           ///< for meshes: source triangle of each triangle; otherwise empty

    /// Returns its index.
    std::uint32_t addPoint(const Eigen::Vector3f& point, const Eigen::Vector3f& normal);
    /// Orders the corners so that the front face is on the side of their normals.
    void addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);
};

/// Tessellation of round shapes, and whether boxes get bevelled edges.
struct Fineness {
    int segments = 16;
    bool bevel = true;
    /// Screen pixels per metre at the closest distance; small shapes get fewer segments. 0: all shapes have the same number.
    double pixelsPerMetre = 0;
};

/// Even number of segments whose chords deviate from the circle by at most half a pixel.
[[nodiscard]] int segmentsFor(double radius, const Fineness& fineness);

[[nodiscard]] ShapeMesh boxMesh(const Eigen::Vector3f& size, bool bevel);
[[nodiscard]] ShapeMesh sphereMesh(float radius, int segments);
/// Along z, closed by flat caps.
[[nodiscard]] ShapeMesh cylinderMesh(float radius, float length, int segments);
/// Along z; `length` is that of the cylindrical part (m).
[[nodiscard]] ShapeMesh capsuleMesh(float radius, float length, int segments);
/// Normals are smoothed where faces meet at less than the crease angle. Degenerate triangles are left out.
[[nodiscard]] ShapeMesh smoothedMesh(const TriangleMesh& mesh);
/// The same surface with one vertex per position and no normals, for shadows.
[[nodiscard]] ShapeMesh bareMesh(const TriangleMesh& mesh);
[[nodiscard]] ShapeMesh bareMesh(const ShapeMesh& mesh);
/// Black is z = 0 and the top row is at +y. Very large maps are subsampled.
[[nodiscard]] ShapeMesh heightfieldMesh(const HeightMap& map, const Eigen::Vector3f& size);

/// The shape of a geom. A missing mesh or height map gives a small marker cube; a Plane (drawn as a floor) and sizes that cannot
/// be drawn give an empty mesh.
[[nodiscard]] ShapeMesh shapeOf(const GeomSpec& geom, Fineness fineness);
/// The same without bevelled edges, as in bareMesh().
[[nodiscard]] ShapeMesh bareShapeOf(const GeomSpec& geom, Fineness fineness);
/// True where the mesh or height map of the geom is missing.
[[nodiscard]] bool isPlaceholder(const GeomSpec& geom);
/// True for a mesh that uses the colours and textures of its own file, because the text names no material for it.
[[nodiscard]] bool hasOwnAppearance(const GeomSpec& geom);

} // namespace trundle
