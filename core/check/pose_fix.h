#pragma once
#include <optional>

#include <trundle/geometry.h>

#include "base/diagnostic.h"
#include "project/project.h"

namespace trundle {

/// The edit that moves a robot's start by at least `offset` (m, world), to whole tenths of a millimetre. A member of a Grid or Scatter
/// moves with all others, and only up or down. Nothing where the text gives no place that can be written.
[[nodiscard]] std::optional<Fix> moveFix(const Loaded& loaded, const RobotSpec& robot, const Vec3& offset);

} // namespace trundle
