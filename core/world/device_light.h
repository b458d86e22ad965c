#pragma once
// The light table of the services; its context is a ServiceContext.

#include <trundle/abi_light.h>

namespace trundle {

[[nodiscard]] const TrundleServicesLight* servicesLight();

} // namespace trundle
