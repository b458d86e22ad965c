#pragma once
// Viewport overlay of a scene, invisible to sensors: translucent shapes attached to bodies, and an image on the floor.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <trundle/geometry.h>

namespace trundle {

/// Triangles with a colour per vertex; front faces are counter-clockwise.
struct TintedMesh {
    std::vector<Eigen::Vector3f> points, normals;
    std::vector<std::array<std::uint8_t, 3>> colours;
    std::vector<std::uint32_t> indices;
};

/// A mesh attached to a body; body indices as in BodyPoses.
struct TintedShape {
    std::shared_ptr<const TintedMesh> mesh;
    std::size_t body = 0;
    Pose mounting;
};

/// RGBA of cells on the level floor, or at z = 0 if there is none; rows along y, starting at the lower edge.
struct FloorPicture {
    double x = 0, y = 0; ///< m, lower left corner
    double width = 0, depth = 0;
    std::uint32_t columns = 0, rows = 0;
    std::vector<std::uint8_t> pixels; ///< columns * rows * 4
};

/// Immutable. Parts that are unchanged since the last overlay are not rebuilt.
struct SceneOverlay {
    std::shared_ptr<const std::vector<TintedShape>> shapes; ///< may be null
    std::shared_ptr<const FloorPicture> floor;              ///< may be null
};

} // namespace trundle
