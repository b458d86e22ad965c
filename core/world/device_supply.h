#pragma once
// The supply table of the services; its context is a ServiceContext.

#include <trundle/abi_supply.h>

namespace trundle {

[[nodiscard]] const TrundleServicesSupply* servicesSupply();

} // namespace trundle
