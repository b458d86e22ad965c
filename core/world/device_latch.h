#pragma once
// The latch table of the services; its context is a ServiceContext.

#include <trundle/abi_latch.h>

namespace trundle {

[[nodiscard]] const TrundleServicesLatch* servicesLatch();

} // namespace trundle
