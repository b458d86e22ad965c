#include "world/ode/lcp/side_search.h"

#include <algorithm>
#include <cmath>

#include "world/ode/lcp/solve_dense.h"

namespace trundle {

namespace {

constexpr int kMostChanges = 20;
constexpr unsigned kMostOutside = 16; // with more an elimination of what is inside costs less
constexpr double kMuch = 0.5;         // of the most that a row misses
constexpr double kBeyond = 1e-12;     // beyond a bound, of it

/// x by the factor; it is zero before `begin`.
void substitute(const SideProblem& problem, double* x, unsigned begin) {
    for (unsigned i = begin; i < problem.rows; ++i) {
        const double* const factor = problem.factor + std::size_t(i) * problem.rows;
        for (unsigned j = begin; j < i; ++j) x[i] -= factor[j] * x[j];
        x[i] *= factor[i];
    }
}

/// By its transpose.
void substituteBack(const SideProblem& problem, double* x) {
    for (unsigned i = problem.rows; i-- > 0;) {
        const double* const factor = problem.factor + std::size_t(i) * problem.rows;
        x[i] *= factor[i];
        for (unsigned j = 0; j < i; ++j) x[j] -= factor[j] * x[i];
    }
}

} // namespace

bool SideSearch::solve(const SideProblem& problem) {
    start(problem);
    for (int round = 0; round < kMostChanges; ++round) {
        if (!changeSides(problem)) return refine(problem);
        if (m_outside.size() > kMostOutside || !solveOutside(problem, problem.inside)) return false;
    }
    return false;
}

void SideSearch::start(const SideProblem& problem) {
    m_x.assign(problem.inside.begin(), problem.inside.end());
    m_sides.assign(problem.rows, Side::Inside);
    m_next.resize(problem.rows);
    m_misses.resize(problem.rows);
    m_excess.assign(problem.rows, 0);
    m_known.assign(problem.rows, 0);
    m_columns.resize(std::size_t(problem.rows) * problem.rows);
}

/// Those that are most wrong, as all at once would go too far. False where none is.
bool SideSearch::changeSides(const SideProblem& problem) {
    double most = 0;
    bool wrong = false;
    for (unsigned i = 0; i < problem.rows; ++i) {
        m_next[i] = i < problem.frictionBegin ? better(problem, i) : sideOfFriction(problem, i);
        if (m_next[i] == m_sides[i]) continue;
        wrong = true;
        m_misses[i] = missOf(problem, i);
        most = std::max(most, m_misses[i]);
    }
    m_outside.clear();
    for (unsigned i = 0; i < problem.rows; ++i) {
        if (m_next[i] != m_sides[i] && m_misses[i] >= kMuch * most) m_sides[i] = m_next[i];
        if (m_sides[i] != Side::Inside) m_outside.push_back(i);
    }
    return wrong;
}

SideSearch::Side SideSearch::better(const SideProblem& problem, unsigned row) const {
    const double low = problem.low[row], high = problem.high[row];
    if (low == high) return Side::Low;
    if (m_sides[row] != Side::Inside) return kept(row);
    return m_x[row] < low ? Side::Low : m_x[row] > high ? Side::High : Side::Inside;
}

SideSearch::Side SideSearch::sideOfFriction(const SideProblem& problem, unsigned row) const {
    const unsigned load = problem.loads[row];
    const Side own = m_sides[row];
    const double most = m_sides[load] == Side::Inside ? problem.high[row] * m_x[load] : 0;
    if (own == Side::Inside && std::abs(m_x[row]) > (1 + kBeyond) * most) return m_x[row] < 0 ? Side::Low : Side::High;
    return most > 0 ? kept(row) : own;
}

/// How far beyond its bound, or back from it, its force wants to go.
double SideSearch::missOf(const SideProblem& problem, unsigned row) const {
    if (m_sides[row] != Side::Inside) return std::abs(m_excess[row]) * columnOf(problem, row)[row];
    if (row >= problem.frictionBegin) return std::abs(m_x[row]) - problem.high[row] * std::max(0.0, m_x[problem.loads[row]]);
    return std::max(problem.low[row] - m_x[row], m_x[row] - problem.high[row]);
}

/// A row at its bound stays there as long as that holds something back.
SideSearch::Side SideSearch::kept(unsigned row) const {
    const Side side = m_sides[row];
    if (side == Side::Inside) return side;
    return (side == Side::Low ? m_excess[row] >= 0 : m_excess[row] <= 0) ? side : Side::Inside;
}

/// The solution for these sides, from one for all inside or for them. False where it is nearly singular.
bool SideSearch::solveOutside(const SideProblem& problem, std::span<const double> from) {
    const auto count = static_cast<unsigned>(m_outside.size());
    m_dense.resize(std::size_t(count) * (count + 1));
    for (const unsigned row : m_outside) findColumn(problem, row);
    for (unsigned a = 0; a < count; ++a) {
        const unsigned row = m_outside[a];
        double* const to = m_dense.data() + std::size_t(a) * (count + 1);
        const bool friction = row >= problem.frictionBegin;
        const double side = m_sides[row] == Side::Low ? -1 : 1, share = friction ? side * problem.high[row] : 0;
        const unsigned load = friction ? problem.loads[row] : 0;
        const double bound = friction ? 0 : side < 0 ? problem.low[row] : problem.high[row];
        for (unsigned b = 0; b < count; ++b) {
            const double* const column = columnOf(problem, m_outside[b]);
            to[b] = column[row] - share * column[load];
        }
        to[count] = bound - from[row] + share * from[load];
    }
    if (!solveDense(m_dense, count)) return false;
    std::ranges::copy(from, m_x.begin());
    for (unsigned a = 0; a < count; ++a) {
        const double excess = m_dense[std::size_t(a) * (count + 1) + count];
        const double* const column = columnOf(problem, m_outside[a]);
        for (unsigned i = 0; i < problem.rows; ++i) m_x[i] += excess * column[i];
        m_excess[m_outside[a]] = excess;
    }
    return true;
}

/// What rounding has left: the matrix without bounds may be far nearer to singular than what is inside them.
bool SideSearch::refine(const SideProblem& problem) {
    m_refined.assign(problem.rows, 0);
    for (const unsigned row : m_outside) m_refined[row] = m_excess[row];
    substitute(problem, m_refined.data(), m_outside.empty() ? problem.rows : m_outside.front());
    for (unsigned i = 0; i < problem.rows; ++i) {
        const double* const factor = problem.factor + std::size_t(i) * problem.rows;
        for (unsigned j = 0; j < i; ++j) m_refined[j] -= factor[j] * m_x[i];
        m_refined[i] += problem.right[i] - m_x[i] / factor[i];
    }
    substituteBack(problem, m_refined.data());
    for (unsigned i = 0; i < problem.rows; ++i) m_refined[i] += m_x[i];
    return solveOutside(problem, m_refined);
}

/// Of the inverse.
void SideSearch::findColumn(const SideProblem& problem, unsigned row) {
    if (m_known[row]) return;
    m_known[row] = true;
    double* const x = m_columns.data() + std::size_t(row) * problem.rows;
    std::fill_n(x, problem.rows, 0.0);
    x[row] = 1;
    substitute(problem, x, row);
    substituteBack(problem, x);
}

} // namespace trundle
