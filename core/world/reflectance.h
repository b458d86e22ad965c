#pragma once
#include "model/experiment_spec.h"

namespace trundle {

/// Share of the light that a material returns, 0..1: the luminance of its colour (ITU-R BT.709), times that of its texture on average.
/// Display values are converted to linear light by their square, as everywhere where light is summed.
[[nodiscard]] double reflectanceOf(const MaterialSpec& material);

} // namespace trundle
