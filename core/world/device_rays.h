#pragma once
// The ray table of the services; its context is a ServiceContext.

#include <trundle/abi.h>

namespace trundle {

[[nodiscard]] const TrundleServicesRays* servicesRays();

} // namespace trundle
