#pragma once
#include "schema/registry.h"

namespace trundle {

/// Adds the kinds of the model itself: settings, Material, Surface, configs, instances, layouts, Body, geoms, joints. Must be
/// called once, on an empty registry.
void addModelKinds(Registry& registry);

/// The registry as used for texts: every controller kind also has UpdatePeriod, Isolation and Budget.
[[nodiscard]] Registry withControllerProperties(const Registry& registry);
/// The same for one kind.
[[nodiscard]] Kind withControllerProperties(Kind kind);

} // namespace trundle
