#pragma once
#include <cstdint>

namespace trundle {

/// The most memory this process held so far, kB (VmHWM: unlike ru_maxrss it does not count the parent before exec). 0 if unknown.
[[nodiscard]] std::uint64_t peakMemoryKb();

} // namespace trundle
