#pragma once
#include "world/world_device.h"

namespace trundle {

/// Fills the table that devices call during a tick. The context outlives the table.
void fillServices(TrundleServices& services, ServiceContext& context, double tick);

} // namespace trundle
