#pragma once
// The solver of solve_lcp.cpp, which ODE calls by itself.

#include <cstdint>

namespace trundle {

/// Of this thread.
struct SolvedIslands {
    std::uint64_t count = 0;     ///< each time that ODE had rows to solve for bodies that hang together
    std::uint64_t leftToOde = 0; ///< those that ODE's own solver had to take
};

/// As long as it lives, a larger island of this thread that cannot be solved here is given up: its solution is nonsense. ODE's own solver
/// would take a second for some hundred rows.
class OnlyQuickIslands {
public:
    OnlyQuickIslands();
    ~OnlyQuickIslands();
    OnlyQuickIslands(const OnlyQuickIslands&) = delete;
    OnlyQuickIslands& operator=(const OnlyQuickIslands&) = delete;
    [[nodiscard]] bool gaveUp() const;
    /// Multiplications since.
    [[nodiscard]] std::uint64_t work() const;

private:
    std::uint64_t m_before;
};

/// As long as it lives, the islands of this thread are solved by RowSweeps.
class SweptIslands {
public:
    explicit SweptIslands(double h); ///< h: tick, s
    ~SweptIslands();
    SweptIslands(const SweptIslands&) = delete;
    SweptIslands& operator=(const SweptIslands&) = delete;
    [[nodiscard]] bool gaveUp() const; ///< the solution is nonsense
};

/// Also has the linker take that file, which nothing else refers to.
[[nodiscard]] SolvedIslands solvedIslands();

} // namespace trundle
