#include "scene/shapes/picture_map.h"

#include <array>

namespace trundle {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

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

bool onAxis(const Vector3f& p) { return std::hypot(p.x() - 0.5f, p.y() - 0.5f) < 1e-4f; }

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

std::vector<Vector2f> pictureCoordinates(const ShapeMesh& mesh, PictureMap map, double scale) {
    const Measure measure(mesh);
    std::vector<Vector2f> coordinates;
    coordinates.reserve(mesh.indices.size());
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::array<Vector3f, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.points[mesh.indices[i + k]];
        const Vector3f normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        for (Vector3f& corner : corners) corner = measure.share(corner);
        const bool cap = isPictureCap(normal, map);
        std::array<Vector2f, 3> at;
        for (std::size_t k = 0; k < 3; ++k) at[k] = pictureAt(corners[k], normal, map);
        if ((map == PictureMap::Cylinder && !cap) || map == PictureMap::Sphere) fixSeam(corners, at);
        for (const Vector2f& corner : at) coordinates.push_back(corner * static_cast<float>(scale));
    }
    return coordinates;
}

} // namespace trundle
