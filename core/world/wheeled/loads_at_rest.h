#pragma once
// What carries a weight on level ground: points that give way alike, as those of the general engine do.

#include <span>
#include <vector>

#include "world/wheeled/planar_shape.h"

namespace trundle {

/// Shares of the weight: a + b x + c y, seen from the centre of mass. A point that would pull carries nothing. `middle`: where the line of
/// the weight meets the ground, beside the centre of mass if gravity is tilted.
[[nodiscard]] std::vector<double> loadsAtRest(std::span<const Vec2> points, const Vec2& middle = Vec2::Zero());

/// Moment of friction over its force where what these points carry only turns, m. Corners and rims carry what is loose, as in the
/// general engine: half the diagonal of a box, R of a disc; under even pressure it would be 0.38 a for a square of side a and 2/3 R.
[[nodiscard]] double turningLever(std::span<const Vec2> points);

} // namespace trundle
