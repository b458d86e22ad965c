#pragma once
// For piles whose loads can be shared in so many ways that the exact solver finds no end: the same rows, one after the other, each within
// what its load allows just then, until all are nearly met. How a load is shared between contacts is left as it falls. Method:
// projected Gauss-Seidel, forth and back, with the way from one pass to the next as the direction of a conjugate gradient
// (Silcowitz-Hansen, Niebe, Erleben 2010, "A nonsmooth nonlinear conjugate gradient method for interactive contact force problems").

#include <vector>

#include "world/ode/lcp/island_rows.h"

namespace trundle {

/// When a solution is good enough, and when it is given up.
struct SweepLimits {
    int passes;
    double tolerance; ///< m/s^2: of the residual of each row
};

class RowSweeps {
public:
    /// `pairs` as of RowSolver. Where rows are not met after all passes, the solution that was nearest; false if that is far from any.
    [[nodiscard]] bool solve(const IslandRows& island, double* pairs, const SweepLimits& limits);

private:
    /// A contact: what bounds its friction comes first.
    struct Group {
        unsigned begin, rows;
        std::size_t blocks, values; ///< where those of its row begin
    };

    void group(const IslandRows& island);
    void gather(const IslandRows& island);
    void addBlock(const IslandRows& island, const Group& rows, const Group& columns);
    [[nodiscard]] double pass(const IslandRows& island, const double* pairs);
    [[nodiscard]] double relax(const IslandRows& island, const double* pairs, std::size_t index);
    void accelerate();

    std::vector<Group> m_groups;                  ///< and one more behind the last
    std::vector<unsigned> m_blocks;               ///< what is not zero: the group of its columns
    std::vector<double> m_values;                 ///< of blocks one after the other, row by row
    std::vector<std::vector<unsigned>> m_touched; ///< by group: groups before it that have a block with it
    std::vector<double> m_x, m_before, m_direction, m_best;
    double m_lastStep = 0; ///< squared
};

} // namespace trundle
