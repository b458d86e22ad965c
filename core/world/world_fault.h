#pragma once
#include <string>

#include "world/world_objects.h"

namespace trundle {

/// Advice for the most likely cause of a fault: deep penetration, much lighter than its neighbours, or forces too strong for the tick.
[[nodiscard]] std::string faultAdvice(BodyHandle body, const WorldObjects& objects, const Engine& engine, double tick);

} // namespace trundle
