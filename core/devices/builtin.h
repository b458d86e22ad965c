#pragma once
// The devices that come with the program. Each is written against the SDK alone, as a module's device is.

#include <string_view>

#include <trundle/abi.h>

#include "schema/registry.h"

namespace trundle {

/// Adds their kinds. Fails only where one of the names is taken.
[[nodiscard]] Status addDeviceKinds(Registry& registry);

/// The table of functions of a built-in device; nullptr where there is none of that name. Good for the whole program.
[[nodiscard]] const TrundleKind* findBuiltInDevice(std::string_view kind);

} // namespace trundle
