#pragma once
// How units move on with their velocities, and the states of their bodies.

#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// A tick of h seconds. Positions follow the new velocities; the turn is exact to the fifth order of its angle.
void moveOn(WheeledUnit& unit, double h);

/// Of a body's frame, as BodyState says.
void publishStates(WheeledObjects& objects, std::uint32_t unit);

/// Rotation about a unit axis, the same on every machine: sine and cosine by their series.
[[nodiscard]] Quat turnAbout(const Vec3& axis, double angle);

} // namespace trundle
