#pragma once
// x with S x = g + w, lo <= x <= hi, where w is zero inside its bounds, not negative at lo and not positive at hi; S is positive definite,
// so that there is one such x. Method: principal pivoting by blocks (Judice and Pires): all rows that are wrong change sides at once.

#include <span>
#include <vector>

#include "world/ode/lcp/tile_matrix.h"

namespace trundle {

struct BoxProblem {
    const double* matrix; ///< both triangles, row after row
    unsigned stride;
    std::span<const double> right;     ///< g
    std::span<const double> low, high; ///< may be infinite
};

class BoxSolver {
public:
    /// Forgets all; every row starts inside its bounds.
    void start(unsigned rows);
    /// Solves the first `rows` rows, the rest is zero; begins at the sides that an earlier solution ended with. False where it does not
    /// get there.
    [[nodiscard]] bool solve(const BoxProblem& problem, unsigned rows);
    [[nodiscard]] std::span<const double> solution() const { return m_x; }
    [[nodiscard]] bool isAtBound(unsigned row) const { return m_sides[row] != Side::Inside; }

private:
    enum class Side : unsigned char { Inside, Low, High };

    [[nodiscard]] bool solveInside(const BoxProblem& problem, unsigned rows);
    void guess(const BoxProblem& problem, unsigned rows, int sweeps);
    [[nodiscard]] bool descend(const BoxProblem& problem, unsigned rows);
    [[nodiscard]] double excessOf(const BoxProblem& problem, unsigned rows, unsigned row) const;
    [[nodiscard]] Side better(const BoxProblem& problem, unsigned rows, unsigned row) const;

    std::vector<Side> m_sides, m_next;
    std::vector<double> m_x, m_packed, m_from;
    std::vector<unsigned> m_inside;
    TileMatrix m_matrix;
};

} // namespace trundle
