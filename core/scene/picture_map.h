#pragma once
// How a picture is laid on the triangles of a geom.

#include <array>
#include <string_view>

#include <Eigen/Core>

#include "model/body_spec.h"
#include "scene/shape_mesh.h"

namespace trundle {

enum class PictureMap : std::uint8_t { Planar, Box, Cylinder, Sphere };

/// What a material's TextureMap means for a geom; `auto` follows its shape.
[[nodiscard]] PictureMap pictureMapOf(std::string_view word, GeomShape shape);

/// Texture coordinates of the three corners of each triangle in turn: (0, 0) is the top left corner of the picture, (1, 1) the
/// lower right one, `scale` of it lie side by side. A box has the picture on each side, upright and never mirrored seen from
/// outside; a cylinder once around and on each cap.
[[nodiscard]] std::vector<Eigen::Vector2f> pictureCoordinates(const ShapeMesh& mesh, PictureMap map, double scale);

} // namespace trundle
