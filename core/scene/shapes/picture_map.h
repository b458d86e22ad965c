#pragma once
// Texture coordinates of the triangles of a geom.

#include <Eigen/Core>

#include "model/picture_place.h"
#include "scene/shapes/shape_mesh.h"

namespace trundle {

/// Texture coordinates of the three corners of each triangle in order: (0, 0) is the top left corner of the texture, (1, 1) the
/// lower right one; `scale` repetitions. A box has the texture on each side, upright and not mirrored when seen from outside; a
/// cylinder has it once around and once on each cap.
[[nodiscard]] std::vector<Eigen::Vector2f> pictureCoordinates(const ShapeMesh& mesh, PictureMap map, double scale);

} // namespace trundle
