#pragma once
#include "model/instance_variants.h"
#include "project/object_place.h"

namespace trundle {

/// Of a Robot, Static, Grid or Scatter of a load, with the meshes that the load has read. Nothing for another kind of part.
[[nodiscard]] std::optional<InstanceVariants> variantsOf(const Loaded& loaded, const ObjectPlace& place);

} // namespace trundle
