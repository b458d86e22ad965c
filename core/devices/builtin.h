#pragma once
// The built-in devices. Like the devices of a module, each uses only the SDK.

#include <string_view>

#include <trundle/abi.h>

#include "schema/registry.h"

namespace trundle {

/// Adds their kinds to the registry. Fails only if a name is already used.
[[nodiscard]] Status addDeviceKinds(Registry& registry);

/// The function table of a built-in device; nullptr if there is none with that name. Valid for the whole program.
[[nodiscard]] const TrundleKind* findBuiltInDevice(std::string_view kind);

} // namespace trundle
