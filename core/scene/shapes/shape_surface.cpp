// Meshes and height maps: shapes whose normals must be computed.

#include <cstring>
#include <unordered_map>

#include "scene/shapes/shape_mesh.h"

namespace trundle {
namespace {

using Eigen::Vector3f;

constexpr float kCreaseCosine = 0.80f;     // about 37 degrees
constexpr std::size_t kMaxNeighbours = 48; // corners with more faces are drawn flat, which keeps smoothing linear in time
constexpr std::uint32_t kMaxSamples = 512; // per side of a height map

struct PointKey {
    std::array<float, 3> at;
    bool operator==(const PointKey&) const = default;
};
struct PointHash {
    std::size_t operator()(const PointKey& key) const {
        std::uint64_t hash = 0xcbf29ce484222325ull;
        for (const float value : key.at) {
            std::uint32_t bits;
            std::memcpy(&bits, &value, sizeof bits);
            hash = (hash ^ bits) * 0x9e3779b97f4a7c15ull;
            hash ^= hash >> 29;
        }
        return static_cast<std::size_t>(hash);
    }
};

struct Face {
    std::uint32_t source;                 // triangle index in the mesh
    std::array<std::uint32_t, 3> corners; // indices of welded points
    Vector3f normal;                      // unit
    std::array<float, 3> angles;          // rad, at the corners; weights of the normals

    [[nodiscard]] float angleAt(std::uint32_t corner) const {
        return corner == corners[0] ? angles[0] : corner == corners[1] ? angles[1] : angles[2];
    }
};

float angleBetween(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    return static_cast<float>(std::atan2(a.cross(b).norm(), a.dot(b)));
}

/// Merges points at equal positions, so that normals are smooth across the seams of a file.
template <class Points> std::vector<std::uint32_t> weld(const Points& all, std::vector<Vector3f>& points) {
    std::unordered_map<PointKey, std::uint32_t, PointHash> known;
    std::vector<std::uint32_t> welded;
    welded.reserve(all.size());
    for (const auto& p : all) {
        // Adding 0 turns -0 into +0.
        const PointKey key{{static_cast<float>(p[0]) + 0.f, static_cast<float>(p[1]) + 0.f, static_cast<float>(p[2]) + 0.f}};
        const auto [it, isNew] = known.try_emplace(key, static_cast<std::uint32_t>(points.size()));
        if (isNew) points.emplace_back(key.at[0], key.at[1], key.at[2]);
        welded.push_back(it->second);
    }
    return welded;
}

std::vector<Face> facesOf(const TriangleMesh& mesh, const std::vector<std::uint32_t>& welded,
                          const std::vector<Vector3f>& points) {
    std::vector<Face> faces;
    for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto& t = mesh.triangles[i];
        if (t[0] >= welded.size() || t[1] >= welded.size() || t[2] >= welded.size()) continue;
        Face face{i, {welded[t[0]], welded[t[1]], welded[t[2]]}, Vector3f::Zero(), {}};
        const Eigen::Vector3d a = points[face.corners[0]].cast<double>(), b = points[face.corners[1]].cast<double>(),
                              c = points[face.corners[2]].cast<double>();
        const Eigen::Vector3d across = (b - a).cross(c - a);
        const double area = across.norm();
        if (!(area > 1e-18) || !std::isfinite(area)) continue;
        face.normal = (across / area).cast<float>();
        face.angles = {angleBetween(b - a, c - a), angleBetween(c - b, a - b), angleBetween(a - c, b - c)};
        faces.push_back(face);
    }
    return faces;
}

} // namespace

ShapeMesh smoothedMesh(const TriangleMesh& mesh) {
    std::vector<Vector3f> points;
    const std::vector<std::uint32_t> welded = weld(mesh.points, points);
    const std::vector<Face> faces = facesOf(mesh, welded, points);

    // Faces adjacent to each point, as one flat list.
    std::vector<std::uint32_t> start(points.size() + 1, 0), around(faces.size() * 3);
    for (const Face& face : faces)
        for (const std::uint32_t c : face.corners) ++start[c + 1];
    for (std::size_t i = 1; i < start.size(); ++i) start[i] += start[i - 1];
    std::vector<std::uint32_t> fill(start.begin(), start.end() - 1);
    for (std::uint32_t f = 0; f < faces.size(); ++f)
        for (const std::uint32_t c : faces[f].corners) around[fill[c]++] = f;

    ShapeMesh result;
    result.points.reserve(faces.size() * 3);
    for (const Face& face : faces) {
        result.sources.push_back(face.source);
        for (const std::uint32_t c : face.corners) {
            Vector3f normal = face.normal;
            if (start[c + 1] - start[c] <= kMaxNeighbours) {
                normal.setZero();
                for (std::uint32_t i = start[c]; i < start[c + 1]; ++i) {
                    const Face& other = faces[around[i]];
                    if (other.normal.dot(face.normal) >= kCreaseCosine) normal += other.normal * other.angleAt(c);
                }
            }
            result.indices.push_back(static_cast<std::uint32_t>(result.points.size()));
            result.points.push_back(points[c]);
            result.normals.push_back(normal.norm() > 0 ? Vector3f(normal.normalized()) : face.normal);
        }
    }
    return result;
}

ShapeMesh bareMesh(const TriangleMesh& mesh) {
    ShapeMesh result;
    const std::vector<std::uint32_t> welded = weld(mesh.points, result.points);
    for (const Face& face : facesOf(mesh, welded, result.points))
        result.indices.insert(result.indices.end(), face.corners.begin(), face.corners.end());
    return result;
}

ShapeMesh bareMesh(const ShapeMesh& mesh) {
    ShapeMesh result;
    const std::vector<std::uint32_t> welded = weld(mesh.points, result.points);
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const std::uint32_t a = welded[mesh.indices[i]], b = welded[mesh.indices[i + 1]], c = welded[mesh.indices[i + 2]];
        if (a != b && b != c && c != a) result.indices.insert(result.indices.end(), {a, b, c});
    }
    return result;
}

ShapeMesh heightfieldMesh(const HeightMap& map, const Vector3f& size) {
    ShapeMesh mesh;
    if (map.columns < 2 || map.rows < 2 || map.heights.size() < std::size_t(map.columns) * map.rows) return mesh;
    const std::uint32_t columns = std::min(map.columns, kMaxSamples), rows = std::min(map.rows, kMaxSamples);
    const auto sampleColumn = [&](std::uint32_t i) {
        return std::uint32_t(std::uint64_t(i) * (map.columns - 1) / (columns - 1));
    };
    const auto sampleRow = [&](std::uint32_t j) { return std::uint32_t(std::uint64_t(j) * (map.rows - 1) / (rows - 1)); };
    mesh.points.reserve(std::size_t(columns) * rows);
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t column = sampleColumn(i), row = sampleRow(j);
            const float height = map.heights[std::size_t(row) * map.columns + column];
            mesh.points.emplace_back((float(column) / float(map.columns - 1) - 0.5f) * size.x(),
                                     (0.5f - float(row) / float(map.rows - 1)) * size.y(),
                                     std::isfinite(height) ? height * size.z() : 0.f);
        }
    }
    const auto at = [&](std::uint32_t i, std::uint32_t j) -> const Vector3f& {
        return mesh.points[std::size_t(j) * columns + i];
    };
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const Vector3f along = at(std::min(i + 1, columns - 1), j) - at(i ? i - 1 : 0, j);
            const Vector3f across = at(i, j ? j - 1 : 0) - at(i, std::min(j + 1, rows - 1));
            const Vector3f normal = along.cross(across);
            mesh.normals.push_back(normal.norm() > 0 ? Vector3f(normal.normalized()) : Vector3f(0, 0, 1));
        }
    }
    for (std::uint32_t j = 0; j + 1 < rows; ++j) {
        for (std::uint32_t i = 0; i + 1 < columns; ++i) {
            const std::uint32_t a = j * columns + i, b = a + 1, c = a + columns, d = c + 1;
            mesh.indices.insert(mesh.indices.end(), {a, c, b, b, c, d});
        }
    }
    return mesh;
}

} // namespace trundle
