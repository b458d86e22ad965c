#include "world/ode/lcp/row_solver.h"
#include "world/ode/lcp/work.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "world/ode/lcp/solve_dense.h"

namespace trundle {

namespace {

constexpr unsigned kFewRows = 48; // that many are a full matrix, and their order does not matter
constexpr double kHuge = 1e300;
constexpr int kMostRounds = 10, kFastRounds = 8, kLoadSweeps = 100;
constexpr double kSameLoad = 1e-6;

} // namespace

bool RowSolver::solve(const IslandRows& island, double* pairs) {
    m_isExact = true;
    sort(island);
    if (island.rows <= kFewRows && solveFew(island, pairs)) return true;
    if (!reduce(island, pairs) || !solveBounded(island)) return false;
    m_matrix.solveBack(0, m_begin, m_x.data());
    return write(island, pairs);
}

bool RowSolver::solve(const IslandRows& island, double* pairs, RowSweeps& sweeps, const SweepLimits& limits) {
    sort(island);
    if (m_free.empty()) return sweeps.solve(island, pairs, limits);
    std::ranges::sort(m_bounded); // friction behind what bounds it
    if (!reduce(island, pairs)) return false;
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_bounds.resize(2 * std::size_t(bounded));
    m_pairs.resize(2 * std::size_t(bounded));
    m_normals.resize(bounded);
    for (unsigned i = 0; i < bounded; ++i) {
        const unsigned row = m_bounded[i];
        std::copy_n(island.bounds + 2 * row, 2, m_bounds.begin() + 2 * i);
        m_pairs[2 * i] = m_right[i];
        const int normal = island.normals ? island.normals[row] : -1;
        m_normals[i] = normal < 0 ? -1 : static_cast<int>(m_places[static_cast<unsigned>(normal)] - m_begin);
    }
    if (!sweeps.solve({bounded, m_rest.data(), bounded, m_bounds.data(), m_normals.data()}, m_pairs.data(), limits)) return false;
    for (unsigned i = 0; i < bounded; ++i) m_x[m_begin + i] = m_pairs[2 * i + 1];
    m_matrix.solveBack(0, m_begin, m_x.data());
    return write(island, pairs);
}

/// Eliminates the free rows.
bool RowSolver::reduce(const IslandRows& island, const double* pairs) {
    const bool full = island.rows <= kFewRows;
    place(TileMatrix::padded(static_cast<unsigned>(m_free.size())));
    if (!full) {
        findPattern(island);
        order();
    }
    if (!eliminate(island, pairs)) return false;
    pack(full);
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_x.assign(TileMatrix::padded(m_begin + bounded + 1), 0);
    m_x[m_begin + bounded] = -1; // the right side, as a row
    return true;
}

bool RowSolver::write(const IslandRows& island, double* pairs) const {
    for (unsigned i = 0; i < island.rows; ++i)
        if (!std::isfinite(m_x[m_places[i]])) return false;
    for (unsigned i = 0; i < island.rows; ++i) pairs[2 * i + 1] = m_x[m_places[i]];
    return true;
}

/// As it mostly is with robots that drive: all rows are inside their bounds, and one elimination says so. Else it serves to find which are
/// not. False where those are not found.
bool RowSolver::solveFew(const IslandRows& island, double* pairs) {
    place(static_cast<unsigned>(m_free.size()));
    const unsigned last = island.rows;
    m_matrix.start(last + 1, true);
    fillFull(island);
    double* const right = m_matrix.rowOf(last);
    for (unsigned i = 0; i < last; ++i) right[m_places[i] * TileMatrix::kTile] = pairs[2 * i];
    right[last * TileMatrix::kTile] = kHuge; // it is eliminated with its tile
    if (!m_matrix.eliminate(TileMatrix::padded(last + 1))) return false;
    m_x.assign(TileMatrix::padded(last + 1), 0);
    m_x[last] = -1;
    m_matrix.solveBack(0, last, m_x.data());
    boundFriction(island);
    return (isInside() || searchSides(island)) && write(island, pairs);
}

bool RowSolver::searchSides(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_factor.resize(std::size_t(bounded) * bounded);
    m_loads.resize(bounded);
    m_right.resize(bounded);
    for (unsigned i = 0; i < bounded; ++i) {
        for (unsigned j = 0; j <= i; ++j) m_factor[std::size_t(i) * bounded + j] = m_matrix.atInFull(m_begin + i, m_begin + j);
        m_right[i] = m_matrix.atInFull(m_begin + bounded, m_begin + i);
        if (i < m_frictionBegin) continue;
        m_loads[i] = loadOf(island, i);
        m_high[i] = island.bounds[2 * m_bounded[i] + 1];
    }
    const std::span inside(m_x.data() + m_begin, bounded);
    if (!m_search.solve({bounded, m_frictionBegin, m_factor.data(), m_right, inside, m_low, m_high, m_loads})) return false;
    std::ranges::copy(m_search.solution(), inside.begin());
    m_matrix.solveBack(0, m_begin, m_x.data());
    return true;
}

bool RowSolver::isInside() const {
    for (unsigned i = 0; i < m_bounded.size(); ++i)
        if (!(m_low[i] <= m_x[m_begin + i] && m_x[m_begin + i] <= m_high[i])) return false;
    return true;
}

void RowSolver::sort(const IslandRows& island) {
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    m_free.clear();
    m_bounded.clear();
    for (unsigned i = 0; i < island.rows; ++i) {
        const bool friction = island.normals && island.normals[i] >= 0;
        const bool open = island.bounds[2 * i] == -kInfinity && island.bounds[2 * i + 1] == kInfinity;
        if (open && !friction) m_free.push_back(i);
        else if (!friction) m_bounded.push_back(i);
    }
    m_frictionBegin = static_cast<unsigned>(m_bounded.size());
    for (unsigned i = 0; island.normals && i < island.rows; ++i)
        if (island.normals[i] >= 0) m_bounded.push_back(i);
    bound(island);
}

void RowSolver::bound(const IslandRows& island) {
    m_low.resize(m_bounded.size());
    m_high.resize(m_bounded.size());
    for (unsigned i = 0; i < m_bounded.size(); ++i) {
        m_low[i] = island.bounds[2 * m_bounded[i]];
        m_high[i] = island.bounds[2 * m_bounded[i] + 1];
    }
}

/// Of friction, from the solution so far.
void RowSolver::boundFriction(const IslandRows& island) {
    for (unsigned i = m_frictionBegin; i < m_bounded.size(); ++i) {
        const double load = m_x[m_places[static_cast<unsigned>(island.normals[m_bounded[i]])]];
        m_high[i] = load > 0 ? island.bounds[2 * m_bounded[i] + 1] * load : 0;
        m_low[i] = -m_high[i];
    }
}

void RowSolver::findPattern(const IslandRows& island) {
    m_words = (island.rows + 63) / 64;
    m_pattern.assign(std::size_t(island.rows) * m_words, 0);
    for (unsigned i = 0; i < island.rows; ++i) {
        const double* const row = island.matrix + std::size_t(i) * island.stride;
        for (unsigned begin = 0; begin <= i; begin += 64) {
            std::uint64_t bits = 0;
            const unsigned count = std::min(64u, i + 1 - begin);
            for (unsigned k = 0; k < count; ++k) bits |= std::uint64_t(row[begin + k] != 0) << k;
            m_pattern[std::size_t(i) * m_words + begin / 64] = bits;
        }
    }
}

/// Where each row stands in the matrix: first the free ones, then from `begin` on the bounded ones.
void RowSolver::place(unsigned begin) {
    m_places.resize(m_free.size() + m_bounded.size());
    m_begin = begin;
    for (unsigned i = 0; i < m_free.size(); ++i) m_places[m_free[i]] = i;
    for (unsigned i = 0; i < m_bounded.size(); ++i) m_places[m_bounded[i]] = m_begin + i;
}

/// The free rows in the order in which they are eliminated.
void RowSolver::order() {
    const auto free = static_cast<unsigned>(m_free.size());
    const unsigned words = (free + 63) / 64;
    m_freePattern.assign(std::size_t(free) * words, 0);
    for (unsigned i = 0; i < free; ++i) {
        m_freePattern[std::size_t(i) * words + i / 64] |= std::uint64_t(1) << i % 64; // also where the value is zero
        for (unsigned w = 0; w < m_words; ++w)
            for (std::uint64_t bits = m_pattern[std::size_t(m_free[i]) * m_words + w]; bits; bits &= bits - 1) {
                const unsigned j = m_places[w * 64 + static_cast<unsigned>(std::countr_zero(bits))];
                if (j >= free) continue;
                m_freePattern[std::size_t(i) * words + j / 64] |= std::uint64_t(1) << j % 64;
                m_freePattern[std::size_t(j) * words + i / 64] |= std::uint64_t(1) << i % 64;
            }
    }
    unsigned next = 0;
    for (const unsigned i : m_order.find(m_freePattern, free, words)) m_places[m_free[i]] = next++;
}

void RowSolver::fillFull(const IslandRows& island) {
    constexpr unsigned kStep = TileMatrix::kTile;
    const auto free = static_cast<unsigned>(m_free.size());
    const unsigned inPlace = free > 0 && m_free.back() + 1 == free ? free : 0; // as ODE has them
    const unsigned* const places = m_places.data();
    for (unsigned i = 0; i < island.rows; ++i) {
        const double* const from = island.matrix + std::size_t(i) * island.stride;
        const unsigned here = places[i], plain = std::min(inPlace, i + 1);
        double* const row = m_matrix.rowOf(here);
        for (unsigned j = 0; j < plain; ++j) row[j * kStep] = from[j];
        for (unsigned j = plain; j <= i; ++j) {
            const unsigned there = places[j];
            *(there <= here ? row + there * kStep : m_matrix.rowOf(there) + here * kStep) = from[j];
        }
    }
}

void RowSolver::fillSparse(const IslandRows& island) {
    for (unsigned i = 0; i < island.rows; ++i) {
        const double* const row = island.matrix + std::size_t(i) * island.stride;
        const unsigned here = m_places[i];
        for (unsigned w = 0; w < m_words; ++w)
            for (std::uint64_t bits = m_pattern[std::size_t(i) * m_words + w]; bits; bits &= bits - 1) {
                const unsigned j = w * 64 + static_cast<unsigned>(std::countr_zero(bits)), there = m_places[j];
                m_matrix.set(std::max(here, there), std::min(here, there), row[j]);
            }
    }
}

bool RowSolver::eliminate(const IslandRows& island, const double* pairs) {
    const unsigned last = m_begin + static_cast<unsigned>(m_bounded.size());
    const bool full = island.rows <= kFewRows;
    m_matrix.start(last + 1, full);
    if (full) fillFull(island);
    else fillSparse(island);
    for (unsigned i = 0; i < island.rows; ++i) m_matrix.set(last, m_places[i], pairs[2 * i]);
    for (auto i = static_cast<unsigned>(m_free.size()); i < m_begin; ++i) m_matrix.set(i, i, 1);
    return m_matrix.eliminate(m_begin);
}

/// What remains for the bounded rows.
void RowSolver::pack(bool full) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_rest.resize(std::size_t(bounded) * bounded);
    m_right.resize(bounded);
    const auto pack = [&](auto&& at) {
        for (unsigned i = 0; i < bounded; ++i) {
            for (unsigned j = 0; j <= i; ++j)
                m_rest[std::size_t(i) * bounded + j] = m_rest[std::size_t(j) * bounded + i] = at(m_begin + i, m_begin + j);
            m_right[i] = at(m_begin + bounded, m_begin + i);
        }
    };
    if (full) pack([this](unsigned row, unsigned column) { return m_matrix.atInFull(row, column); });
    else pack([this](unsigned row, unsigned column) { return m_matrix.at(row, column); });
}

bool RowSolver::solveBox(unsigned rows) {
    const BoxProblem problem{m_rest.data(), static_cast<unsigned>(m_bounded.size()), m_right, m_low, m_high};
    if (!m_box.solve(problem, rows)) return false;
    std::copy_n(m_box.solution().begin(), rows, m_x.begin() + m_begin);
    return true;
}

bool RowSolver::solveBounded(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_box.start(bounded);
    if (!solveBox(m_frictionBegin)) return false;
    if (m_frictionBegin == bounded) return true;
    boundFriction(island);
    return solveBox(bounded) && followLoads(island);
}

/// Friction changes the loads that bound it. Each round takes from the last one which rows are at their bounds, and solves for loads and
/// friction together; where those rows stay the same, that is the solution.
bool RowSolver::followLoads(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    for (int round = 0; round < kMostRounds; ++round) {
        boundFriction(island);
        if (isConsistent()) return true;
        if (round >= kFastRounds || !slide(island)) sweep(island);
        if (!solveBox(bounded)) return false;
    }
    boundFriction(island);
    m_isExact = isConsistent();
    return true;
}

/// One row after the other, friction within what its load allows just then: slower, and comes to an end where sides would change for ever.
void RowSolver::sweep(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    double* const x = m_x.data() + m_begin;
    t_multiplications += std::uint64_t(kLoadSweeps) * bounded * bounded;
    for (int round = 0; round < kLoadSweeps; ++round)
        for (unsigned i = 0; i < bounded; ++i) {
            const double* const row = m_rest.data() + std::size_t(i) * bounded;
            double excess = -m_right[i];
            for (unsigned j = 0; j < bounded; ++j) excess += row[j] * x[j];
            if (i >= m_frictionBegin) {
                m_high[i] = std::max(0.0, island.bounds[2 * m_bounded[i] + 1] * x[loadOf(island, i)]);
                m_low[i] = -m_high[i];
            }
            x[i] = std::clamp(x[i] - excess / row[i], m_low[i], m_high[i]);
        }
}

/// Whether friction is what its bounds say, as they follow from the solution.
bool RowSolver::isConsistent() const {
    for (unsigned i = m_frictionBegin; i < m_bounded.size(); ++i) {
        const double x = std::abs(m_x[m_begin + i]), allowed = kSameLoad * m_high[i];
        if (x > m_high[i] + allowed || (m_box.isAtBound(i) && x < m_high[i] - allowed)) return false;
    }
    return true;
}

/// The bounds of friction where rows stay on their sides. False where there is no such solution.
bool RowSolver::slide(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_inside.clear();
    for (unsigned i = 0; i < bounded; ++i)
        if (!m_box.isAtBound(i) && std::abs(m_x[m_begin + i]) <= m_high[i]) m_inside.push_back(i);
    const auto count = static_cast<unsigned>(m_inside.size());
    std::vector<unsigned>& places = m_columns;
    places.assign(bounded, count);
    for (unsigned k = 0; k < count; ++k) places[m_inside[k]] = k;
    m_dense.assign(std::size_t(count) * (count + 1), 0);
    for (unsigned k = 0; k < count; ++k) {
        const double* const from = m_rest.data() + std::size_t(m_inside[k]) * bounded;
        double* const to = m_dense.data() + std::size_t(k) * (count + 1);
        to[count] = m_right[m_inside[k]];
        for (unsigned j = 0; j < bounded; ++j) {
            if (places[j] < count) to[places[j]] += from[j];
            else if (j < m_frictionBegin) to[count] -= from[j] * m_x[m_begin + j];
            else if (const unsigned load = places[loadOf(island, j)]; load < count)
                to[load] += (m_x[m_begin + j] < 0 ? -from[j] : from[j]) * island.bounds[2 * m_bounded[j] + 1];
        }
    }
    if (!solveDense(m_dense, count)) return false;
    for (unsigned j = m_frictionBegin; j < bounded; ++j) {
        const unsigned load = places[loadOf(island, j)];
        m_high[j] = load < count
                        ? std::max(0.0, island.bounds[2 * m_bounded[j] + 1] * m_dense[std::size_t(load) * (count + 1) + count])
                        : 0;
        m_low[j] = -m_high[j];
    }
    return true;
}

/// Among the bounded rows.
unsigned RowSolver::loadOf(const IslandRows& island, unsigned friction) const {
    return m_places[static_cast<unsigned>(island.normals[m_bounded[friction]])] - m_begin;
}

} // namespace trundle
