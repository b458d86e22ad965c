#include "world/ode/lcp/tile_matrix.h"
#include "world/ode/lcp/work.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace trundle {

namespace {

constexpr unsigned kTile = TileMatrix::kTile, kArea = kTile * kTile;
constexpr double kLeastRest = 1e-14; // of the value on the diagonal before

using Column = double __attribute__((vector_size(kTile * sizeof(double))));

// Everything is inlined into its two callers: one for any processor, one for those with vectors of four.
#define TRUNDLE_INLINE inline __attribute__((always_inline))

TRUNDLE_INLINE void load(Column& column, const double* from) { std::memcpy(&column, from, sizeof column); }
TRUNDLE_INLINE void store(const Column& column, double* to) { std::memcpy(to, &column, sizeof column); }

TRUNDLE_INLINE double* tileRow(const TileMatrix::Data& m, std::size_t row) { return m.tiles + row * (row + 1) / 2 * kArea; }

/// c -= a b^T
TRUNDLE_INLINE void subtract(Column (&c)[kTile], const double* a, const double* b) {
    for (unsigned k = 0; k < kTile; ++k) {
        Column column;
        load(column, a + k * kTile);
        for (unsigned j = 0; j < kTile; ++j) c[j] -= column * b[k * kTile + j];
    }
}

/// Subtracts what the columns left of `end` (tiles) have in common.
TRUNDLE_INLINE void subtractAll(const TileMatrix::Data& m, unsigned row, unsigned column, unsigned end, Column (&c)[kTile]) {
    const double *const a = tileRow(m, row), *const b = tileRow(m, column);
    const std::uint64_t *const inRow = m.filled + std::size_t(row) * m.words, *const inColumn =
                                                                                  m.filled + std::size_t(column) * m.words;
    for (unsigned word = 0; word * 64 < end; ++word) {
        std::uint64_t both = inRow[word] & inColumn[word];
        if (end - word * 64 < 64) both &= (std::uint64_t(1) << (end - word * 64)) - 1;
        for (; both; both &= both - 1) {
            const std::size_t k = word * 64 + static_cast<unsigned>(std::countr_zero(both));
            subtract(c, a + k * kArea, b + k * kArea);
        }
    }
}

/// A tile on the diagonal.
TRUNDLE_INLINE bool factorTile(double* tile, const double* before) {
    double t[kArea];
    std::memcpy(t, tile, sizeof t);
    for (unsigned j = 0; j < kTile; ++j) {
        for (unsigned k = 0; k < j; ++k)
            for (unsigned i = j; i < kTile; ++i) t[j * kTile + i] -= t[k * kTile + i] * t[k * kTile + j];
        const double pivot = t[j * kTile + j];
        if (!(pivot > kLeastRest * before[j])) return false;
        const double scale = std::sqrt(pivot) * (1 / pivot); // both at the same time
        for (unsigned i = j + 1; i < kTile; ++i) t[j * kTile + i] *= scale;
        t[j * kTile + j] = scale;
    }
    std::memcpy(tile, t, sizeof t);
    return true;
}

/// c times the inverse of the transposed factor of a tile on the diagonal.
TRUNDLE_INLINE void divide(Column (&c)[kTile], const double* factor) {
    for (unsigned j = 0; j < kTile; ++j) {
        for (unsigned k = 0; k < j; ++k) c[j] -= c[k] * factor[k * kTile + j];
        c[j] *= factor[j * kTile + j];
    }
}

TRUNDLE_INLINE bool eliminateAll(const TileMatrix::Data& m, unsigned eliminated) {
    for (unsigned column = 0; column < m.rows; ++column) {
        const unsigned end = std::min(column, eliminated);
        double* const diagonal = tileRow(m, column) + std::size_t(column) * kArea;
        for (unsigned row = column; row < m.rows; ++row) {
            if (!(m.filled[std::size_t(row) * m.words + column / 64] >> column % 64 & 1)) continue;
            double* const tile = tileRow(m, row) + std::size_t(column) * kArea;
            double before[kTile];
            for (unsigned j = 0; j < kTile; ++j) before[j] = tile[j * kTile + j];
            Column c[kTile];
            for (unsigned j = 0; j < kTile; ++j) load(c[j], tile + j * kTile);
            subtractAll(m, row, column, end, c);
            if (row != column && column < eliminated) divide(c, diagonal);
            for (unsigned j = 0; j < kTile; ++j) store(c[j], tile + j * kTile);
            if (row == column && column < eliminated && !factorTile(tile, before)) return false;
        }
    }
    return true;
}

bool eliminateAnywhere(const TileMatrix::Data& m, unsigned eliminated) { return eliminateAll(m, eliminated); }

#ifdef __x86_64__
__attribute__((target("avx2"))) bool eliminateInFours(const TileMatrix::Data& m, unsigned eliminated) {
    return eliminateAll(m, eliminated);
}
const bool hasFours = __builtin_cpu_supports("avx2");
#else
bool eliminateInFours(const TileMatrix::Data& m, unsigned eliminated) { return eliminateAll(m, eliminated); }
constexpr bool hasFours = false;
#endif

} // namespace

void TileMatrix::start(unsigned rows, bool full) {
    m_rows = padded(rows) / kTile;
    m_words = (m_rows + 63) / 64;
    m_full = full;
    m_filled.assign(std::size_t(m_rows) * m_words, full ? ~std::uint64_t(0) : 0);
    const std::size_t size = rowStart(m_rows) * kArea;
    if (m_tiles.size() < size) m_tiles.resize(size);
    if (full) std::fill_n(m_tiles.begin(), size, 0.0);
    else
        for (unsigned row = 0; row < m_rows; ++row) fill(row, row);
    for (unsigned row = rows; row < m_rows * kTile; ++row) set(row, row, 1);
}

/// With zeros.
void TileMatrix::fill(unsigned row, unsigned column) {
    m_filled[std::size_t(row) * m_words + column / 64] |= std::uint64_t(1) << column % 64;
    std::fill_n(m_tiles.data() + (rowStart(row) + column) * kArea, kArea, 0.0);
}

/// Tiles that become other than zero.
void TileMatrix::fillIn(unsigned eliminated) {
    for (unsigned column = 1; column < m_rows; ++column)
        for (unsigned row = column + 1; row < m_rows; ++row) {
            if (isFilled(row, column)) continue;
            std::uint64_t common = 0;
            const unsigned end = std::min(column, eliminated);
            for (unsigned word = 0; word * 64 < end; ++word) {
                std::uint64_t both = m_filled[std::size_t(row) * m_words + word] & m_filled[std::size_t(column) * m_words + word];
                if (end - word * 64 < 64) both &= (std::uint64_t(1) << (end - word * 64)) - 1;
                common |= both;
            }
            if (common) fill(row, column);
        }
}

bool TileMatrix::eliminate(unsigned rows) {
    if (!m_full) fillIn(rows / kTile);
    for (unsigned row = 0; row < m_rows; ++row) {
        std::uint64_t tiles = 0;
        for (unsigned word = 0; word < m_words; ++word) tiles += std::popcount(m_filled[std::size_t(row) * m_words + word]);
        t_multiplications += tiles * tiles * kTile * kArea;
    }
    const Data data{m_tiles.data(), m_filled.data(), m_rows, m_words};
    return hasFours ? eliminateInFours(data, rows / kTile) : eliminateAnywhere(data, rows / kTile);
}

void TileMatrix::solveBack(unsigned begin, unsigned end, double* x) const {
    for (unsigned column = padded(end) / kTile; column-- > begin / kTile;) {
        Column sums[kTile] = {};
        for (unsigned row = column + 1; row < m_rows; ++row) {
            if (!isFilled(row, column)) continue;
            const double* const tile = m_tiles.data() + (rowStart(row) + column) * kArea;
            Column of;
            load(of, x + std::size_t(row) * kTile);
            for (unsigned j = 0; j < kTile; ++j) {
                Column factor;
                load(factor, tile + j * kTile);
                sums[j] -= factor * of;
            }
        }
        const double* const tile = m_tiles.data() + (rowStart(column) + column) * kArea;
        double* const here = x + std::size_t(column) * kTile;
        for (unsigned j = std::min(kTile, end - column * kTile); j-- > 0;) {
            double sum = (sums[j][0] + sums[j][1]) + (sums[j][2] + sums[j][3]);
            for (unsigned i = j + 1; i < kTile; ++i) sum -= tile[j * kTile + i] * here[i];
            here[j] = sum * tile[j * kTile + j];
        }
    }
}

} // namespace trundle
