#pragma once
#include <trundle/geometry.h>

namespace trundle {

/// The rotation by the smallest angle that turns the direction `from` to `to`, of any length but 0; half a turn about any axis across
/// if they are opposite. Eigen's FromTwoVectors does the same, but takes three seconds to compile in each file that uses it.
[[nodiscard]] Quat shortestTurn(const Vec3& from, const Vec3& to);

} // namespace trundle
