#include "world/ode/row_solver.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace trundle {

namespace {

constexpr unsigned kFewRows = 48; // that many are a full matrix, and their order does not matter

} // namespace

bool RowSolver::solve(const IslandRows& island, double* pairs) {
    sort(island);
    place();
    if (island.rows > kFewRows) {
        findPattern(island);
        order();
    }
    if (!eliminate(island, pairs)) return false;
    pack();
    if (!solveBounded(island)) return false;
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_x.assign(TileMatrix::padded(m_begin + bounded + 1), 0);
    for (unsigned i = 0; i < bounded; ++i) m_x[m_begin + i] = m_box.solution()[i];
    m_x[m_begin + bounded] = -1; // the right side, as a row
    m_matrix.solveBack(m_begin, m_x.data());
    for (unsigned i = 0; i < island.rows; ++i)
        if (!std::isfinite(m_x[m_places[i]])) return false;
    for (unsigned i = 0; i < island.rows; ++i) pairs[2 * i + 1] = m_x[m_places[i]];
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

/// Where each row stands in the matrix: first the free ones, then the bounded ones.
void RowSolver::place() {
    m_places.resize(m_free.size() + m_bounded.size());
    m_begin = TileMatrix::padded(static_cast<unsigned>(m_free.size()));
    for (unsigned i = 0; i < m_free.size(); ++i) m_places[m_free[i]] = i;
    for (unsigned i = 0; i < m_bounded.size(); ++i) m_places[m_bounded[i]] = m_begin + i;
}

/// The free rows in the order in which they are eliminated.
void RowSolver::order() {
    const auto free = static_cast<unsigned>(m_free.size());
    const unsigned words = (free + 63) / 64;
    m_freePattern.assign(std::size_t(free) * words, 0);
    for (unsigned i = 0; i < free; ++i)
        for (unsigned w = 0; w < m_words; ++w)
            for (std::uint64_t bits = m_pattern[std::size_t(m_free[i]) * m_words + w]; bits; bits &= bits - 1) {
                const unsigned j = m_places[w * 64 + static_cast<unsigned>(std::countr_zero(bits))];
                if (j >= free) continue;
                m_freePattern[std::size_t(i) * words + j / 64] |= std::uint64_t(1) << j % 64;
                m_freePattern[std::size_t(j) * words + i / 64] |= std::uint64_t(1) << i % 64;
            }
    unsigned next = 0;
    for (const unsigned i : m_order.find(m_freePattern, free, words)) m_places[m_free[i]] = next++;
}

void RowSolver::fillFull(const IslandRows& island) {
    for (unsigned i = 0; i < island.rows; ++i) {
        const double* const from = island.matrix + std::size_t(i) * island.stride;
        const unsigned here = m_places[i];
        double* const row = m_matrix.rowOf(here);
        for (unsigned j = 0; j <= i; ++j) {
            const unsigned there = m_places[j];
            if (there <= here) row[there * TileMatrix::kTile] = from[j];
            else m_matrix.rowOf(there)[here * TileMatrix::kTile] = from[j];
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
void RowSolver::pack() {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_rest.resize(std::size_t(bounded) * bounded);
    m_right.resize(bounded);
    for (unsigned i = 0; i < bounded; ++i) {
        for (unsigned j = 0; j <= i; ++j)
            m_rest[std::size_t(i) * bounded + j] = m_rest[std::size_t(j) * bounded + i] = m_matrix.at(m_begin + i, m_begin + j);
        m_right[i] = m_matrix.at(m_begin + bounded, m_begin + i);
    }
}

bool RowSolver::solveBounded(const IslandRows& island) {
    const auto bounded = static_cast<unsigned>(m_bounded.size());
    m_low.resize(bounded);
    m_high.resize(bounded);
    m_box.start(bounded);
    for (unsigned i = 0; i < bounded; ++i) {
        m_low[i] = island.bounds[2 * m_bounded[i]];
        m_high[i] = island.bounds[2 * m_bounded[i] + 1];
    }
    const BoxProblem problem{m_rest.data(), bounded, m_right, m_low, m_high};
    if (!m_box.solve(problem, m_frictionBegin)) return false;
    if (m_frictionBegin == bounded) return true;
    for (unsigned i = m_frictionBegin; i < bounded; ++i) {
        const unsigned place = m_places[static_cast<unsigned>(island.normals[m_bounded[i]])] - m_begin;
        const double load = m_box.solution()[place];
        m_high[i] = load == 0 ? 0 : std::abs(m_high[i] * load);
        m_low[i] = -m_high[i];
    }
    return m_box.solve(problem, bounded);
}

} // namespace trundle
