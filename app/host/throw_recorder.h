#pragma once
#include <cstdint>
#include <vector>

namespace trundle {

/// Where the code of the module was when the main thread threw its last exception since forgetThrow(): offsets of return addresses
/// in the module, innermost first; empty: there was none. This process replaces __cxa_throw of the C++ library for that (Itanium C++
/// ABI, Exception Handling, 2.4.3).
[[nodiscard]] std::vector<std::uint64_t> lastThrow();
void forgetThrow();

} // namespace trundle
