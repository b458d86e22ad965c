#pragma once
// Few well-spread points out of the many that a collider finds.

#include <array>

#include <ode/ode.h>

#include <trundle/geometry.h>

namespace trundle {

inline constexpr int kMaxFound = 32;
inline constexpr int kMaxDirections = 3; ///< in which a pair has contacts
inline constexpr double kSideHit = 0.7;  ///< cosine: what is turned farther away lies on another side
using PointGroup = std::array<int, kMaxFound>;
using UsedPoints = std::array<bool, kMaxFound>;

/// Takes the first sound point that is not used yet and all that face its way into `group`, marks them as used and gives their number.
[[nodiscard]] int takeDirection(const dContactGeom* found, int count, UsedPoints& used, PointGroup& group);

/// Brings the deepest point of the group, then always the one farthest from those chosen, to its front: at most `most`. Gives their number.
[[nodiscard]] int spread(const dContactGeom* found, PointGroup& group, int count, int most);

/// Brings the deepest point of the group, the one farthest from it, and up to two more that widen the area most to its front: at most
/// `most`, or four. Gives their number; what lies in one line has two.
[[nodiscard]] int spreadWidely(const dContactGeom* found, PointGroup& group, int count, int most);

/// The deepest point that is not used yet, -1 for none. What lies on its side is used up with it; what is as deep shares in the normal.
[[nodiscard]] int takeGround(const dContactGeom* found, int count, UsedPoints& used, Vec3& normal);

} // namespace trundle
