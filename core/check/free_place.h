#pragma once
// Private to core/check.

#include <optional>

#include "check/start_scene.h"

namespace trundle {

/// The shortest level move (m, world frame) that brings a robot beside another one without meeting anything else, by the boxes around
/// all; of one that is on the other, the move up, if there is room. Nothing if each place along the axes of the world is taken.
[[nodiscard]] std::optional<Vec3> moveBeside(const StartScene& scene, std::size_t robot, std::size_t other);

} // namespace trundle
