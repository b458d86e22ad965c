#pragma once
// What a window lays over a scene and no sensor ever sees: translucent shapes that go with bodies, and a picture on the floor.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include <Eigen/Core>

#include <trundle/geometry.h>

namespace trundle {

/// Triangles with a colour at each corner, seen from outside counter-clockwise.
struct TintedMesh {
    std::vector<Eigen::Vector3f> points, normals;
    std::vector<std::array<std::uint8_t, 3>> colours;
    std::vector<std::uint32_t> indices;
};

/// A mesh that stands in a body; bodies count as in BodyPoses.
struct TintedShape {
    std::shared_ptr<const TintedMesh> mesh;
    std::size_t body = 0;
    Pose mounting;
};

/// Red, green, blue and opacity of cells on the level floor, or at z = 0 where there is none; rows along y, the first at the lower edge.
struct FloorPicture {
    double x = 0, y = 0; ///< m, of its lower left corner
    double width = 0, depth = 0;
    std::uint32_t columns = 0, rows = 0;
    std::vector<std::uint8_t> pixels; ///< columns * rows * 4
};

/// Immutable; what is the same as before is not made anew.
struct SceneOverlay {
    std::shared_ptr<const std::vector<TintedShape>> shapes; ///< none: nullptr
    std::shared_ptr<const FloorPicture> floor;              ///< none: nullptr
};

} // namespace trundle
