#pragma once
// Quantities that properties of several kinds have.

#include "schema/registry.h"

namespace trundle {

inline constexpr double kFarthestCoordinate = 1e5; ///< m; larger coordinates stop a run

constexpr Quantity position() { return metres().within(-kFarthestCoordinate, kFarthestCoordinate); }
constexpr Quantity direction() { return number().within(-1e6, 1e6); }
constexpr Quantity angles() { return degrees().within(-1e6, 1e6); }

} // namespace trundle
