#pragma once
// The joints table of the services; its context is a ServiceContext.

#include <trundle/abi_joint.h>

namespace trundle {

[[nodiscard]] const TrundleServicesJoints* servicesJoints();

} // namespace trundle
