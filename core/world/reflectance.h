#pragma once
#include <vector>

#include <trundle/abi_light.h>

#include "model/experiment_spec.h"

namespace trundle {

/// Share of the light that a material returns, 0..1: the luminance (ITU-R BT.709) of its picture on average, else of its colour.
/// Display values are converted to linear light by their square, as everywhere where light is summed.
[[nodiscard]] double reflectanceOf(const MaterialSpec& material);

/// The same at a point of a geom: of its picture there, as it is drawn, between pixels as a renderer does. `point` and `normal`
/// (outwards) are in the geom's frame; `low` and `size` are those of its bounding box.
[[nodiscard]] double reflectanceAt(const MaterialSpec& material, GeomShape shape, const Vec3& point, const Vec3& normal,
                                   const Vec3& low, const Vec3& size);

/// The lights of an experiment by their luminance.
[[nodiscard]] std::vector<TrundleLight> lightsOf(const ExperimentSpec& experiment);

/// Lower corner and size of a geom's bounding box in its own frame, m; of a plane zeros.
[[nodiscard]] std::pair<Vec3, Vec3> pictureBox(const GeomSpec& geom);

} // namespace trundle
