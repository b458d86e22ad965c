#pragma once
#include "model/resolve/instance_variants.h"
#include "project/objects/object_location.h"

namespace trundle {

/// The shapes of a Robot, Static, Grid or Scatter, with the meshes that the load has read. Nothing for other blocks.
[[nodiscard]] std::optional<InstanceVariants> variantsOf(const LoadedProject& loaded, const ObjectLocation& place);

} // namespace trundle
