#include "world/ode/lcp/solve_dense.h"
#include "world/ode/lcp/work.h"

#include <algorithm>
#include <cmath>

namespace trundle {

namespace {

constexpr double kLeastPivot = 1e-12; // of the largest value

} // namespace

bool solveDense(std::vector<double>& rows, unsigned count) {
    t_multiplications += std::uint64_t(count) * count * count / 3;
    const unsigned width = count + 1;
    double largest = 0;
    for (const double x : rows) largest = std::max(largest, std::abs(x));
    const auto at = [&](unsigned row, unsigned column) -> double& { return rows[std::size_t(row) * width + column]; };
    for (unsigned k = 0; k < count; ++k) {
        unsigned pivot = k;
        for (unsigned i = k + 1; i < count; ++i)
            if (std::abs(at(i, k)) > std::abs(at(pivot, k))) pivot = i;
        if (!(std::abs(at(pivot, k)) > kLeastPivot * largest)) return false;
        if (pivot != k) std::swap_ranges(&at(k, 0), &at(k, 0) + width, &at(pivot, 0));
        for (unsigned i = k + 1; i < count; ++i) {
            const double share = at(i, k) / at(k, k);
            if (share == 0) continue;
            for (unsigned j = k + 1; j < width; ++j) at(i, j) -= share * at(k, j);
        }
    }
    for (unsigned k = count; k-- > 0;) {
        for (unsigned j = k + 1; j < count; ++j) at(k, count) -= at(k, j) * at(j, count);
        at(k, count) /= at(k, k);
    }
    return true;
}

} // namespace trundle
