#pragma once
#include <optional>

#include <trundle/geometry.h>

#include "base/diagnostic.h"
#include "project/loading/project.h"

namespace trundle {

/// The edit that moves a robot's start position by at least `offset` (m, world frame), rounded to 0.1 mm. A Grid is moved as a
/// whole, and only vertically. Nothing for a Scatter, and if the position cannot be edited in the text.
[[nodiscard]] std::optional<Fix> moveFix(const LoadedProject& loaded, const RobotSpec& robot, const Vec3& offset);

} // namespace trundle
