#pragma once

#include <cstdint>

namespace trundle {

/// About how many multiplications the solvers of this thread have done, for what decides whether they are worth it.
inline thread_local std::uint64_t t_multiplications = 0;

} // namespace trundle
