#pragma once
#include "world/world_device.h"

namespace trundle {

/// Fills the table through which a device finds its joints, bodies, geoms and peers in its setup. The context is the device, which has
/// its host.
void fillMount(WorldDevice& device, double tick);

} // namespace trundle
