#pragma once
#include "world/world_device.h"

namespace trundle {

/// Fills the table that devices call during a tick; before each call it gets the context of the device, and before each phase the time.
void fillServices(TrundleServices& services, double tick);

} // namespace trundle
