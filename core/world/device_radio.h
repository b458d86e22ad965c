#pragma once
// The radio tables of a mount (its context is the device) and of the services (a ServiceContext).

#include <trundle/abi.h>

namespace trundle {

[[nodiscard]] const TrundleMountRadio* mountRadio();
[[nodiscard]] const TrundleServicesRadio* servicesRadio();

} // namespace trundle
