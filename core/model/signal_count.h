#pragma once
#include <cstdint>

#include "model/component_spec.h"
#include "schema/kind.h"

namespace trundle {

/// A device has signals of at most so many numbers.
inline constexpr std::uint64_t kMaxSignalNumbers = 100000;

/// Numbers in a signal of a device or controller: its count times the values of the fields that its kind names. At least 1; more than
/// kMaxSignalNumbers is reported by the world and counts as 1 here.
[[nodiscard]] std::uint32_t signalCount(const SignalDescription& signal, const ComponentSpec& component);

} // namespace trundle
