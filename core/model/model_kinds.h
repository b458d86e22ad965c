#pragma once
#include "schema/registry.h"

namespace trundle {

/// Adds the kinds that the model itself knows: settings, Material, Surface, configs, instances, layouts, Body, geoms, joints.
/// To be called once, on an empty registry.
void addModelKinds(Registry& registry);

/// The registry as a text sees it: every controller kind has UpdatePeriod, Isolation and Budget as well.
[[nodiscard]] Registry withControllerProperties(const Registry& registry);
/// One kind so completed.
[[nodiscard]] Kind withControllerProperties(Kind kind);

} // namespace trundle
