#pragma once
#include <cstdint>

namespace trundle {

/// Peak memory of this process so far, in kB (VmHWM: unlike ru_maxrss it does not include the parent before exec). 0 if unknown.
[[nodiscard]] std::uint64_t peakMemoryKb();

} // namespace trundle
