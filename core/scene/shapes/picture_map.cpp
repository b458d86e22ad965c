#include "scene/shapes/picture_map.h"

#include <numbers>

namespace trundle {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kFlatCap = 0.9f; // a face whose normal has this |z| or more is a cap

/// Coordinates relative to the mesh's bounding box: 0 at its minimum, 1 at its maximum.
struct Measure {
    Vector3f low = Vector3f::Zero(), size = Vector3f::Ones();
    explicit Measure(const ShapeMesh& mesh) {
        if (mesh.points.empty()) return;
        Vector3f high = low = mesh.points[0];
        for (const Vector3f& p : mesh.points) {
            low = low.cwiseMin(p);
            high = high.cwiseMax(p);
        }
        size = (high - low).cwiseMax(1e-9f);
    }
    [[nodiscard]] Vector3f share(const Vector3f& p) const { return (p - low).cwiseQuotient(size); }
};

Vector2f onBox(const Vector3f& p, const Vector3f& normal) {
    Eigen::Index axis = 0;
    normal.cwiseAbs().maxCoeff(&axis);
    const bool front = normal[axis] > 0;
    if (axis == 0) return {front ? p.y() : 1 - p.y(), 1 - p.z()};
    if (axis == 1) return {front ? 1 - p.x() : p.x(), 1 - p.z()};
    return {p.x(), front ? 1 - p.y() : p.y()};
}

float turnOf(const Vector3f& p) {
    return static_cast<float>(std::atan2(p.y() - 0.5f, p.x() - 0.5f) / (2 * std::numbers::pi)) + 0.5f;
}

bool onAxis(const Vector3f& p) { return std::hypot(p.x() - 0.5f, p.y() - 0.5f) < 1e-4f; }

Vector2f around(const Vector3f& p, PictureMap map) {
    const double height = std::clamp(2.0 * p.z() - 1, -1.0, 1.0);
    const double down = map == PictureMap::Sphere ? 0.5 - std::asin(height) / std::numbers::pi : 1.0 - p.z();
    return {turnOf(p), static_cast<float>(down)};
}

/// Triangles across the seam continue beyond 1; a corner on the axis takes the mean angle of the others.
void fixSeam(const std::array<Vector3f, 3>& corners, std::array<Vector2f, 3>& at) {
    float most = 0;
    for (int i = 0; i < 3; ++i)
        if (!onAxis(corners[std::size_t(i)])) most = std::max(most, at[std::size_t(i)].x());
    float sum = 0;
    int count = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        if (onAxis(corners[i])) continue;
        if (most - at[i].x() > 0.5f) at[i].x() += 1;
        sum += at[i].x();
        ++count;
    }
    for (std::size_t i = 0; i < 3; ++i)
        if (onAxis(corners[i]) && count > 0) at[i].x() = sum / static_cast<float>(count);
}

} // namespace

PictureMap pictureMapOf(std::string_view word, GeomShape shape) {
    if (word == "planar") return PictureMap::Planar;
    if (word == "box") return PictureMap::Box;
    if (word == "cylinder") return PictureMap::Cylinder;
    if (word == "sphere") return PictureMap::Sphere;
    switch (shape) {
    case GeomShape::Sphere:
    case GeomShape::Capsule: return PictureMap::Sphere;
    case GeomShape::Cylinder: return PictureMap::Cylinder;
    case GeomShape::Plane:
    case GeomShape::Heightfield: return PictureMap::Planar;
    default: return PictureMap::Box;
    }
}

std::vector<Vector2f> pictureCoordinates(const ShapeMesh& mesh, PictureMap map, double scale) {
    const Measure measure(mesh);
    std::vector<Vector2f> coordinates;
    coordinates.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Vector3f, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.points[mesh.indices[i + k]];
        const Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        for (Vector3f& corner : corners) corner = measure.share(corner);
        const bool cap = map == PictureMap::Cylinder && std::abs(normal.z()) > kFlatCap;
        std::array<Vector2f, 3> at;
        for (std::size_t k = 0; k < 3; ++k) {
            at[k] = map == PictureMap::Planar       ? Vector2f(corners[k].x(), 1 - corners[k].y())
                    : map == PictureMap::Box || cap ? onBox(corners[k], normal)
                                                    : around(corners[k], map);
        }
        if ((map == PictureMap::Cylinder && !cap) || map == PictureMap::Sphere) fixSeam(corners, at);
        for (const Vector2f& corner : at) coordinates.push_back(corner * static_cast<float>(scale));
    }
    return coordinates;
}

} // namespace trundle
