#pragma once
#include <cstddef>
#include <cstdint>
#include <exception>
#include <string>

namespace trundle {

/// Peak memory of this process so far, in kB (VmHWM: unlike ru_maxrss it does not include the parent before exec). 0 if unknown.
[[nodiscard]] std::uint64_t peakMemoryKb();

/// Asks for large pages for the next `bytes` that the main thread takes from the heap: 2 MB at once, not 4 kB, are much cheaper to get, and
/// to find for the processor. The heap does not shrink after that. No effect where little is wanted, memory is limited (RLIMIT_AS), or the
/// system has no such pages.
void useLargePages(std::size_t bytes);

/// What an exception that no code expects says to a person: of std::bad_alloc how much memory the program has had.
[[nodiscard]] std::string reasonOf(const std::exception& exception);

} // namespace trundle
