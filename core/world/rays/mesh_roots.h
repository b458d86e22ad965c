#pragma once
// Where the beams of a fan start their search in a mesh or height map: the few parts of it that any of them can meet.

#include "world/rays/fan_view.h"
#include "world/rays/triangle_tree.h"

namespace trundle {

/// `fan`: origin and axes of the fan in those of the mesh.
[[nodiscard]] RayRoots rootsOf(const TriangleTree& tree, const LocalBeams& fan, const FanView& view);
[[nodiscard]] RayRoots rootsOf(const HeightCells& cells, const LocalBeams& fan, const FanView& view);

} // namespace trundle
