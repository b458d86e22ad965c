#include "scene/shapes/shape_mesh.h"

#include <numbers>

#include "base/mesh_appearance.h"

namespace trundle {
namespace {

using Eigen::Vector3f;

constexpr float kMaxBevel = 0.004f;      // m
constexpr float kBevelShare = 0.06f;     // fraction of the shortest edge
constexpr float kLargest = 1e5f;         // m; larger shapes cannot be drawn
constexpr float kPlaceholderSize = 0.1f; // m
constexpr double kTurn = 2 * std::numbers::pi;
constexpr int kLeastSegments = 4;

void addQuad(ShapeMesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.addTriangle(a, b, c);
    mesh.addTriangle(a, c, d);
}

/// Ring of a surface of revolution: (radius, z) and the slope of the normal; consecutive rings are joined.
struct Ring {
    double radius, z, normalOut, normalUp;
};

void addRings(ShapeMesh& mesh, const std::vector<Ring>& rings, int segments) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    const auto n = static_cast<std::uint32_t>(segments);
    for (const Ring& ring : rings) {
        for (std::uint32_t s = 0; s < n; ++s) {
            const double a = kTurn * s / segments, c = std::cos(a), d = std::sin(a);
            mesh.addPoint(Eigen::Vector3d(ring.radius * c, ring.radius * d, ring.z).cast<float>(),
                          Eigen::Vector3d(ring.normalOut * c, ring.normalOut * d, ring.normalUp).cast<float>());
        }
    }
    for (std::uint32_t r = 0; r + 1 < rings.size(); ++r) {
        for (std::uint32_t s = 0; s < n; ++s) {
            const std::uint32_t a = first + r * n + s, b = first + r * n + (s + 1) % n;
            if (rings[r + 1].radius <= 0) mesh.addTriangle(a, b, a + n);
            else if (rings[r].radius <= 0) mesh.addTriangle(a, b + n, a + n);
            else addQuad(mesh, a, b, b + n, a + n);
        }
    }
}

void addCap(ShapeMesh& mesh, double radius, double z, double up, int segments) {
    const Vector3f normal(0, 0, static_cast<float>(up));
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (int s = 0; s < segments; ++s) {
        const double a = kTurn * s / segments;
        mesh.addPoint(Eigen::Vector3d(radius * std::cos(a), radius * std::sin(a), z).cast<float>(), normal);
    }
    const auto n = static_cast<std::uint32_t>(segments);
    for (std::uint32_t s = 1; s + 1 < n; ++s) mesh.addTriangle(first, first + s, first + s + 1);
}

} // namespace

std::uint32_t ShapeMesh::addPoint(const Vector3f& point, const Vector3f& normal) {
    points.push_back(point);
    normals.push_back(normal);
    return static_cast<std::uint32_t>(points.size() - 1);
}

void ShapeMesh::addTriangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    const Vector3f face = (points[b] - points[a]).cross(points[c] - points[a]);
    if (face.dot(normals[a] + normals[b] + normals[c]) < 0) std::swap(b, c);
    indices.insert(indices.end(), {a, b, c});
}

int segmentsFor(double radius, const Fineness& fineness) {
    if (!(fineness.pixelsPerMetre > 0)) return fineness.segments;
    const double needed = std::numbers::pi * std::sqrt(radius * fineness.pixelsPerMetre);
    return std::min(fineness.segments, std::max(kLeastSegments, 2 * static_cast<int>(std::ceil(0.5 * std::min(needed, 1e3)))));
}

ShapeMesh boxMesh(const Vector3f& size, bool bevel) {
    ShapeMesh mesh;
    const Vector3f half = 0.5f * size;
    const float cut = bevel ? std::min(kMaxBevel, kBevelShare * size.minCoeff()) : 0.f;
    // corner[face axis][box corner]: each corner of the box has one vertex per adjacent face.
    std::uint32_t corner[3][8];
    for (int axis = 0; axis < 3; ++axis) {
        for (int i = 0; i < 8; ++i) {
            Vector3f point, normal = Vector3f::Zero();
            for (int k = 0; k < 3; ++k) {
                const float sign = (i >> k) & 1 ? 1.f : -1.f;
                point[k] = sign * (k == axis ? half[k] : half[k] - cut);
                if (k == axis) normal[k] = sign;
            }
            corner[axis][i] = mesh.addPoint(point, normal);
        }
    }
    for (int axis = 0; axis < 3; ++axis) {
        const int u = 1 << ((axis + 1) % 3), v = 1 << ((axis + 2) % 3), w = 1 << axis;
        for (const int side : {0, w})
            addQuad(mesh, corner[axis][side], corner[axis][side | u], corner[axis][side | u | v], corner[axis][side | v]);
        if (cut <= 0) continue;
        // The four edges along `axis` join a face of axis u to a face of axis v.
        const int faceU = (axis + 1) % 3, faceV = (axis + 2) % 3;
        for (const int side : {0, u, v, u | v})
            addQuad(mesh, corner[faceU][side], corner[faceU][side | w], corner[faceV][side | w], corner[faceV][side]);
    }
    if (cut > 0)
        for (int i = 0; i < 8; ++i) mesh.addTriangle(corner[0][i], corner[1][i], corner[2][i]);
    return mesh;
}

ShapeMesh sphereMesh(float radius, int segments) {
    ShapeMesh mesh;
    std::vector<Ring> rings;
    const int stacks = std::max(2, segments / 2);
    for (int i = 0; i <= stacks; ++i) {
        const double a = std::numbers::pi * i / stacks - std::numbers::pi / 2;
        const double c = i == 0 || i == stacks ? 0.0 : std::cos(a);
        rings.push_back({radius * c, radius * std::sin(a), c, std::sin(a)});
    }
    addRings(mesh, rings, segments);
    return mesh;
}

ShapeMesh cylinderMesh(float radius, float length, int segments) {
    ShapeMesh mesh;
    addRings(mesh, {{radius, -0.5 * length, 1, 0}, {radius, 0.5 * length, 1, 0}}, segments);
    addCap(mesh, radius, 0.5 * length, 1, segments);
    addCap(mesh, radius, -0.5 * length, -1, segments);
    return mesh;
}

ShapeMesh capsuleMesh(float radius, float length, int segments) {
    ShapeMesh mesh;
    std::vector<Ring> rings;
    const int stacks = std::max(2, segments / 4);
    for (int half = 0; half < 2; ++half) {
        for (int i = 0; i <= stacks; ++i) {
            const double a = 0.5 * std::numbers::pi * (half == 0 ? i - stacks : i) / stacks;
            const double c = (half == 0 && i == 0) || (half == 1 && i == stacks) ? 0.0 : std::cos(a);
            rings.push_back({radius * c, radius * std::sin(a) + (half == 0 ? -0.5 : 0.5) * length, c, std::sin(a)});
        }
    }
    addRings(mesh, rings, segments);
    return mesh;
}

bool isPlaceholder(const GeomSpec& geom) {
    switch (geom.shape) {
    case GeomShape::Mesh:
    case GeomShape::Convex: return !geom.mesh || geom.mesh->triangles.empty();
    case GeomShape::Heightfield: return !geom.heightMap || geom.heightMap->columns < 2 || geom.heightMap->rows < 2;
    default: return false;
    }
}

bool hasOwnAppearance(const GeomSpec& geom) {
    if (geom.shape != GeomShape::Mesh || geom.material != 0 || isPlaceholder(geom) || !geom.mesh->look) return false;
    return geom.mesh->look->material.size() == geom.mesh->triangles.size();
}

ShapeMesh shapeOf(const GeomSpec& geom, Fineness fineness) {
    const auto radius = static_cast<float>(geom.radius), length = static_cast<float>(geom.length);
    const Vector3f size = geom.size.cast<float>();
    const auto drawable = [](float value) { return value > 0 && value < kLargest; };
    const int segments = segmentsFor(geom.radius, fineness);
    const bool drawableSize = drawable(size.x()) && drawable(size.y()) && drawable(size.z());
    if (isPlaceholder(geom)) return boxMesh(Vector3f::Constant(kPlaceholderSize), false);
    switch (geom.shape) {
    case GeomShape::Box: return drawableSize ? boxMesh(size, fineness.bevel) : ShapeMesh{};
    case GeomShape::Sphere: return drawable(radius) ? sphereMesh(radius, segments) : ShapeMesh{};
    case GeomShape::Cylinder: return drawable(radius) && drawable(length) ? cylinderMesh(radius, length, segments) : ShapeMesh{};
    case GeomShape::Capsule:
        return drawable(radius) && length >= 0 && length < kLargest ? capsuleMesh(radius, length, segments) : ShapeMesh{};
    case GeomShape::Convex:
    case GeomShape::Mesh: return smoothedMesh(*geom.mesh);
    case GeomShape::Heightfield:
        return size.x() > 0 && size.y() > 0 && size.cwiseAbs().maxCoeff() < kLargest ? heightfieldMesh(*geom.heightMap, size)
                                                                                     : ShapeMesh{};
    case GeomShape::Plane: break;
    }
    return {};
}

ShapeMesh bareShapeOf(const GeomSpec& geom, Fineness fineness) {
    const bool isMesh = geom.shape == GeomShape::Mesh || geom.shape == GeomShape::Convex;
    if (isMesh && !isPlaceholder(geom)) return bareMesh(*geom.mesh);
    fineness.bevel = false;
    return bareMesh(shapeOf(geom, fineness));
}

} // namespace trundle
