#include "world/ode/lcp/box_solver.h"
#include "world/ode/lcp/work.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr int kSweeps = 3, kManySweeps = 100;
constexpr unsigned kRounds = 50;
constexpr int kTries = 3;                 // rounds without fewer rows that are wrong
constexpr unsigned kFullMatrixRows = 64;  // that many are a full matrix
constexpr unsigned kMostDescending = 100; // each step is a whole elimination; of more rows ODE changes one with less work
constexpr double kRounding = 1e-13;       // of the sum of what is added: less of either sign is zero

} // namespace

void BoxSolver::start(unsigned rows) {
    m_sides.assign(rows, Side::Inside);
    m_next = m_sides;
    m_x.assign(rows, 0);
}

bool BoxSolver::solve(const BoxProblem& problem, unsigned rows) {
    for (unsigned i = 0; i < rows; ++i)
        if (m_sides[i] == Side::Inside && problem.low[i] == problem.high[i]) m_sides[i] = Side::Low;
    unsigned least = rows + 1;
    for (int round = 0, tries = kTries; tries >= 0; ++round) {
        if (!solveInside(problem, rows)) return false;
        unsigned wrong = 0;
        for (unsigned i = 0; i < rows; ++i) {
            m_next[i] = better(problem, rows, i);
            wrong += m_next[i] != m_sides[i];
        }
        if (wrong == 0) return true;
        if (round == 0) {
            guess(problem, rows, kSweeps);
            continue;
        }
        if (wrong >= least) --tries;
        least = std::min(least, wrong);
        std::copy_n(m_next.begin(), rows, m_sides.begin());
    }
    if (rows > kMostDescending) return false;
    guess(problem, rows, kManySweeps);
    return descend(problem, rows);
}

/// One row after the other changes its side, from where all are within their bounds. What x minimises falls with each step, so this
/// comes to an end.
bool BoxSolver::descend(const BoxProblem& problem, unsigned rows) {
    m_from = m_x;
    for (unsigned round = 0; round < 2 * rows + kRounds; ++round) {
        if (!solveInside(problem, rows)) return false;
        double step = 1;
        unsigned stopped = rows;
        for (unsigned i = 0; i < rows; ++i) {
            const double bound = std::clamp(m_x[i], problem.low[i], problem.high[i]);
            if (bound == m_x[i]) continue;
            const double share = (bound - m_from[i]) / (m_x[i] - m_from[i]);
            if (share >= step) continue;
            step = share;
            stopped = i;
        }
        for (unsigned i = 0; i < rows; ++i) m_from[i] += step * (m_x[i] - m_from[i]);
        if (stopped != rows) {
            m_sides[stopped] = m_x[stopped] < problem.low[stopped] ? Side::Low : Side::High;
            m_from[stopped] = m_sides[stopped] == Side::Low ? problem.low[stopped] : problem.high[stopped];
            continue;
        }
        unsigned worst = rows;
        double most = 0;
        for (unsigned i = 0; i < rows; ++i) {
            if (better(problem, rows, i) == m_sides[i]) continue;
            const double excess = std::abs(excessOf(problem, rows, i));
            if (excess <= most) continue;
            most = excess;
            worst = i;
        }
        if (worst == rows) return true;
        m_sides[worst] = Side::Inside;
    }
    return false;
}

double BoxSolver::excessOf(const BoxProblem& problem, unsigned rows, unsigned row) const {
    const double* const matrix = problem.matrix + std::size_t(row) * problem.stride;
    double excess = -problem.right[row];
    for (unsigned j = 0; j < rows; ++j) excess += matrix[j] * m_x[j];
    return excess;
}

/// The side on which a row should be, by the present solution.
BoxSolver::Side BoxSolver::better(const BoxProblem& problem, unsigned rows, unsigned row) const {
    const double low = problem.low[row], high = problem.high[row];
    const Side side = m_sides[row];
    if (side == Side::Inside) return m_x[row] < low ? Side::Low : m_x[row] > high ? Side::High : Side::Inside;
    if (low == high) return side;
    const double excess = excessOf(problem, rows, row);
    if (side == Side::Low ? excess >= 0 : excess <= 0) return side;
    const double* const matrix = problem.matrix + std::size_t(row) * problem.stride;
    double size = std::abs(problem.right[row]);
    for (unsigned j = 0; j < rows; ++j) size += std::abs(matrix[j] * m_x[j]);
    return std::abs(excess) <= kRounding * size ? side : Side::Inside;
}

/// Sides from a few sweeps, each of which solves one row after the other.
void BoxSolver::guess(const BoxProblem& problem, unsigned rows, int sweeps) {
    for (unsigned i = 0; i < rows; ++i) m_x[i] = std::clamp(m_x[i], problem.low[i], problem.high[i]);
    t_multiplications += std::uint64_t(sweeps) * rows * rows;
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (unsigned i = 0; i < rows; ++i) {
            const double* const matrix = problem.matrix + std::size_t(i) * problem.stride;
            m_x[i] = std::clamp(m_x[i] - excessOf(problem, rows, i) / matrix[i], problem.low[i], problem.high[i]);
        }
    for (unsigned i = 0; i < rows; ++i)
        m_sides[i] = m_x[i] <= problem.low[i] ? Side::Low : m_x[i] >= problem.high[i] ? Side::High : Side::Inside;
}

/// All rows inside their bounds, with the others at theirs.
bool BoxSolver::solveInside(const BoxProblem& problem, unsigned rows) {
    m_inside.clear();
    bool anyOutside = false; // other than at zero
    for (unsigned i = 0; i < rows; ++i) {
        if (m_sides[i] == Side::Inside) {
            m_inside.push_back(i);
            m_x[i] = 0;
            continue;
        }
        m_x[i] = m_sides[i] == Side::Low ? problem.low[i] : problem.high[i];
        anyOutside |= m_x[i] != 0;
    }
    const auto count = static_cast<unsigned>(m_inside.size());
    const unsigned last = TileMatrix::padded(count);
    const bool full = last < kFullMatrixRows;
    m_matrix.start(last + 1, full);
    for (unsigned a = 0; a < count; ++a) {
        const double* const matrix = problem.matrix + std::size_t(m_inside[a]) * problem.stride;
        if (full) {
            double* const row = m_matrix.rowOf(a);
            for (unsigned b = 0; b <= a; ++b) row[b * TileMatrix::kTile] = matrix[m_inside[b]];
        } else
            for (unsigned b = 0; b <= a; ++b)
                if (matrix[m_inside[b]] != 0) m_matrix.set(a, b, matrix[m_inside[b]]);
        double right = problem.right[m_inside[a]];
        for (unsigned j = 0; anyOutside && j < rows; ++j) right -= matrix[j] * m_x[j];
        m_matrix.set(last, a, right);
    }
    for (unsigned a = count; a < last; ++a) m_matrix.set(a, a, 1);
    if (!m_matrix.eliminate(last)) return false;
    m_packed.assign(TileMatrix::padded(last + 1), 0);
    m_packed[last] = -1;
    m_matrix.solveBack(0, last, m_packed.data());
    for (unsigned a = 0; a < count; ++a) m_x[m_inside[a]] = m_packed[a];
    return true;
}

} // namespace trundle
