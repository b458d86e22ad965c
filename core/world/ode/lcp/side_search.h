#pragma once
// Which rows with bounds are at them, friction with the loads of the same solution: begins with the solution without bounds and its
// factor, which serves throughout. A row at its bound adds one unknown, by how much its equation is off, and a column of the inverse.

#include <span>
#include <vector>

namespace trundle {

struct SideProblem {
    unsigned rows;
    unsigned frictionBegin;          ///< rows from here on are friction
    const double* factor;            ///< lower triangle, row after row; on the diagonal 1 / its value
    std::span<const double> right;   ///< divided by the factor
    std::span<const double> inside;  ///< the solution without bounds
    std::span<const double> low;     ///< of friction unused
    std::span<const double> high;    ///< of friction its share of the load
    std::span<const unsigned> loads; ///< by friction row: which row bounds it
};

class SideSearch {
public:
    /// False where it does not get there.
    [[nodiscard]] bool solve(const SideProblem& problem);
    [[nodiscard]] std::span<const double> solution() const { return m_x; }

private:
    enum class Side : signed char { Low = -1, Inside = 0, High = 1 };

    void start(const SideProblem& problem);
    [[nodiscard]] bool changeSides(const SideProblem& problem);
    [[nodiscard]] Side better(const SideProblem& problem, unsigned row) const;
    [[nodiscard]] Side sideOfFriction(const SideProblem& problem, unsigned row) const;
    [[nodiscard]] Side kept(unsigned row) const;
    [[nodiscard]] double missOf(const SideProblem& problem, unsigned row) const;
    [[nodiscard]] bool solveOutside(const SideProblem& problem, std::span<const double> from);
    [[nodiscard]] bool refine(const SideProblem& problem);
    void findColumn(const SideProblem& problem, unsigned row);

    [[nodiscard]] const double* columnOf(const SideProblem& problem, unsigned row) const {
        return m_columns.data() + std::size_t(row) * problem.rows;
    }

    std::vector<Side> m_sides, m_next;
    std::vector<double> m_x, m_refined, m_excess, m_misses; ///< m_excess: by row, of its equation
    std::vector<double> m_columns;                          ///< of the inverse, one after the other
    std::vector<bool> m_known;                              ///< by row: its column
    std::vector<unsigned> m_outside;                        ///< rows at their bounds
    std::vector<double> m_dense;
};

} // namespace trundle
