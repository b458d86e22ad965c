#pragma once
#include <cstdint>
#include <exception>
#include <string>

namespace trundle {

/// Peak memory of this process so far, in kB (VmHWM: unlike ru_maxrss it does not include the parent before exec). 0 if unknown.
[[nodiscard]] std::uint64_t peakMemoryKb();

/// What an exception that no code expects says to a person: of std::bad_alloc how much memory the program has had.
[[nodiscard]] std::string reasonOf(const std::exception& exception);

} // namespace trundle
