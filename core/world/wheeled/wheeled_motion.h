#pragma once
// How units move on with their velocities, and the states of their bodies.

#include "world/wheeled/wheeled_objects.h"

namespace trundle {

/// A tick of h seconds. Positions follow the new velocities; the turn is exact to the fifth order of its angle.
void moveOn(WheeledUnit& unit, double h);

/// Of a body's frame, as BodyState says.
void publishStates(WheeledObjects& objects, std::uint32_t unit);

} // namespace trundle
