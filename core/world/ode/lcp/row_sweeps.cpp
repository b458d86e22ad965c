#include "world/ode/lcp/row_sweeps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trundle {

namespace {

constexpr double kUseless = 5;           // m/s^2
constexpr double kDivergence = 10;       // times the best residual so far
constexpr unsigned kMostRowsOfGroup = 6; // a contact with rolling friction

double at(const IslandRows& island, unsigned row, unsigned column) {
    return island.matrix[std::size_t(std::max(row, column)) * island.stride + std::min(row, column)];
}

/// What a block of three rows and columns gives: sums that do not wait for each other.
void addThree(const double* values, const double* x, double (&to)[3]) {
    for (unsigned i = 0; i < 3; ++i) to[i] += values[3 * i] * x[0] + values[3 * i + 1] * x[1] + values[3 * i + 2] * x[2];
}

/// Of a contact: its normal, along and across it.
void keepInCone(double* x, const double* bounds) {
    const double along = bounds[3] * x[0], across = bounds[5] * x[0];
    if (!(along > 0 && across > 0)) return;
    const double share = std::hypot(x[1] / along, x[2] / across);
    if (share <= 1) return;
    x[1] /= share;
    x[2] /= share;
}

} // namespace

bool RowSweeps::solve(const IslandRows& island, double* pairs, const SweepLimits& limits) {
    group(island);
    gather(island);
    m_x.assign(island.rows, 0);
    m_direction.assign(island.rows, 0);
    m_lastStep = 0;
    double best = std::numeric_limits<double>::infinity();
    for (int k = 0; k < limits.passes && best >= limits.tolerance; ++k) {
        m_before = m_x;
        const double residual = pass(island, pairs);
        if (residual < best) {
            best = residual;
            m_best = m_x;
        }
        if (residual < kDivergence * best) {
            accelerate();
            continue;
        }
        m_x = m_best; // jammed contacts, whose friction loads each other
        m_direction.assign(m_direction.size(), 0);
        m_lastStep = 0;
    }
    m_x = m_best;
    for (unsigned i = 0; i < island.rows; ++i) pairs[2 * i + 1] = m_x[i];
    return best < kUseless && std::ranges::all_of(m_x, [](double x) { return std::isfinite(x); });
}

void RowSweeps::group(const IslandRows& island) {
    m_groups.clear();
    for (unsigned i = 0; i < island.rows; ++i) {
        const int normal = island.normals ? island.normals[i] : -1;
        const bool belongs =
            normal >= 0 && unsigned(normal) == m_groups.back().begin && i - m_groups.back().begin < kMostRowsOfGroup;
        if (belongs) ++m_groups.back().rows;
        else m_groups.push_back({i, 1, 0, 0});
    }
}

void RowSweeps::gather(const IslandRows& island) {
    const std::size_t count = m_groups.size();
    m_touched.resize(std::max(m_touched.size(), count));
    for (std::size_t a = 0; a < count; ++a) {
        m_touched[a].clear();
        const Group& rows = m_groups[a];
        for (std::size_t b = 0; b < a; ++b) {
            const Group& columns = m_groups[b];
            bool touches = false;
            for (unsigned i = 0; i < rows.rows; ++i) {
                const double* const row = island.matrix + std::size_t(rows.begin + i) * island.stride + columns.begin;
                for (unsigned j = 0; j < columns.rows; ++j) touches |= row[j] != 0;
            }
            if (!touches) continue;
            m_touched[a].push_back(unsigned(b));
            m_touched[b].push_back(unsigned(a));
        }
    }
    m_blocks.clear();
    m_values.clear();
    for (std::size_t a = 0; a < count; ++a) {
        m_groups[a].blocks = m_blocks.size();
        m_groups[a].values = m_values.size();
        for (const unsigned b : m_touched[a]) addBlock(island, m_groups[a], m_groups[b]);
        m_blocks.insert(m_blocks.end(), m_touched[a].begin(), m_touched[a].end());
    }
    m_groups.push_back({island.rows, 0, m_blocks.size(), m_values.size()});
}

void RowSweeps::addBlock(const IslandRows& island, const Group& rows, const Group& columns) {
    for (unsigned i = 0; i < rows.rows; ++i)
        for (unsigned j = 0; j < columns.rows; ++j) m_values.push_back(at(island, rows.begin + i, columns.begin + j));
}

/// Returns the largest residual of a row, m/s^2.
double RowSweeps::pass(const IslandRows& island, const double* pairs) {
    const std::size_t count = m_groups.size() - 1;
    for (std::size_t i = 0; i < count; ++i) (void)relax(island, pairs, i);
    double most = 0;
    for (std::size_t i = count; i-- > 0;) most = std::max(most, relax(island, pairs, i));
    return most;
}

double RowSweeps::relax(const IslandRows& island, const double* pairs, std::size_t index) {
    const Group& group = m_groups[index];
    double excess[kMostRowsOfGroup] = {}, three[3] = {};
    const double* values = m_values.data() + group.values;
    for (std::size_t k = group.blocks; k < m_groups[index + 1].blocks; ++k) {
        const Group& other = m_groups[m_blocks[k]];
        const double* const x = m_x.data() + other.begin;
        if (group.rows == 3 && other.rows == 3) addThree(values, x, three);
        else
            for (unsigned i = 0; i < group.rows; ++i)
                for (unsigned j = 0; j < other.rows; ++j) excess[i] += values[i * other.rows + j] * x[j];
        values += std::size_t(group.rows) * other.rows;
    }
    for (unsigned i = 0; i < 3; ++i) excess[i] += three[i];
    double before[kMostRowsOfGroup], most = 0;
    for (unsigned i = 0; i < group.rows; ++i) {
        const unsigned row = group.begin + i;
        double residual = excess[i] - pairs[2 * row];
        for (unsigned j = 0; j < group.rows; ++j) residual += at(island, row, group.begin + j) * m_x[group.begin + j];
        const bool friction = i > 0 || (island.normals && island.normals[row] >= 0);
        double low = island.bounds[2 * row], high = island.bounds[2 * row + 1];
        if (friction) {
            high *= std::max(0.0, m_x[unsigned(island.normals[row])]);
            low = -high;
        }
        before[i] = m_x[row];
        m_x[row] = std::clamp(before[i] - residual / at(island, row, row), low, high);
    }
    if (group.rows >= 3) keepInCone(m_x.data() + group.begin, island.bounds + 2 * group.begin);
    for (unsigned i = 0; i < group.rows; ++i) {
        const unsigned row = group.begin + i;
        most = std::max(most, std::abs(m_x[row] - before[i]) * at(island, row, row));
    }
    return most;
}

/// Goes on along the way so far, as long as the steps become shorter.
void RowSweeps::accelerate() {
    double step = 0;
    for (std::size_t i = 0; i < m_x.size(); ++i) step += (m_x[i] - m_before[i]) * (m_x[i] - m_before[i]);
    const double share = m_lastStep > 0 ? step / m_lastStep : 2;
    m_lastStep = step;
    if (share > 1) return m_direction.assign(m_direction.size(), 0);
    for (std::size_t i = 0; i < m_x.size(); ++i) {
        const double before = share * m_direction[i];
        m_direction[i] = before + (m_x[i] - m_before[i]);
        m_x[i] += share * before;
    }
}

} // namespace trundle
