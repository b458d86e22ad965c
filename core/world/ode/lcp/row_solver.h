#pragma once
// What the exact solver of ODE does for all rows of joints and contacts that hang together (an island), faster: rows without bounds,
// which are nearly all rows of a robot's joints, are eliminated first as the sparse matrix that they are, and only what remains for
// the rows with bounds is searched for the sides on which those are. Needs: values of the lower triangle of a positive definite
// matrix.

#include <cstdint>
#include <vector>

#include "world/ode/lcp/box_solver.h"
#include "world/ode/lcp/elimination_order.h"
#include "world/ode/lcp/row_sweeps.h"
#include "world/ode/lcp/side_search.h"

namespace trundle {

class RowSolver {
public:
    /// `pairs`: the right sides, each followed by where its solution goes. False where it cannot be found this way: nothing is written.
    [[nodiscard]] bool solve(const IslandRows& island, double* pairs);
    /// The same by sweeps over the bounded rows; false where they find none.
    [[nodiscard]] bool solve(const IslandRows& island, double* pairs, RowSweeps& sweeps, const SweepLimits& limits);
    /// Of the last solution. Where sides change for ever, friction is what the loads just before allowed.
    [[nodiscard]] bool isExact() const { return m_isExact; }

private:
    void sort(const IslandRows& island);
    [[nodiscard]] bool reduce(const IslandRows& island, const double* pairs);
    void bound(const IslandRows& island);
    [[nodiscard]] bool solveFew(const IslandRows& island, double* pairs);
    [[nodiscard]] bool searchSides(const IslandRows& island);
    [[nodiscard]] bool isInside() const;
    void place(unsigned begin);
    void findPattern(const IslandRows& island);
    void order();
    void fillFull(const IslandRows& island);
    void fillSparse(const IslandRows& island);
    [[nodiscard]] bool eliminate(const IslandRows& island, const double* pairs);
    void pack(bool full);
    void boundFriction(const IslandRows& island);
    [[nodiscard]] bool write(const IslandRows& island, double* pairs) const;
    [[nodiscard]] bool solveBounded(const IslandRows& island);
    [[nodiscard]] bool solveBox(unsigned rows);
    [[nodiscard]] bool followLoads(const IslandRows& island);
    void sweep(const IslandRows& island);
    [[nodiscard]] bool isConsistent() const;
    [[nodiscard]] unsigned loadOf(const IslandRows& island, unsigned friction) const;
    [[nodiscard]] bool slide(const IslandRows& island);

    std::vector<unsigned> m_free, m_bounded; ///< rows; of the bounded ones friction comes last
    unsigned m_frictionBegin = 0;            ///< in m_bounded
    unsigned m_words = 0;
    std::vector<std::uint64_t> m_pattern; ///< by row: a bit for each value that is not zero, lower triangle
    std::vector<std::uint64_t> m_freePattern;
    EliminationOrder m_order;
    std::vector<unsigned> m_places; ///< by row: in m_matrix
    unsigned m_begin = 0;           ///< in m_matrix: of the bounded rows
    TileMatrix m_matrix;
    std::vector<double> m_rest, m_right, m_low, m_high, m_x; ///< m_rest: both triangles
    std::vector<double> m_factor;                            ///< of the bounded rows
    std::vector<unsigned> m_loads;
    SideSearch m_search;
    BoxSolver m_box;
    std::vector<unsigned> m_inside, m_columns;
    std::vector<double> m_dense;
    std::vector<double> m_bounds, m_pairs; ///< of the bounded rows, for sweeps
    std::vector<int> m_normals;
    bool m_isExact = true;
};

} // namespace trundle
