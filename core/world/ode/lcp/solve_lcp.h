#pragma once
// The solver of solve_lcp.cpp, which ODE calls by itself.

#include <cstdint>

namespace trundle {

/// Of this thread.
struct SolvedIslands {
    std::uint64_t count = 0;     ///< each time that ODE had rows to solve for bodies that hang together
    std::uint64_t leftToOde = 0; ///< those that ODE's own solver had to take
};

/// Also has the linker take that file, which nothing else refers to.
[[nodiscard]] SolvedIslands solvedIslands();

} // namespace trundle
