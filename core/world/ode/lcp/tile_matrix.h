#pragma once
// A symmetric matrix in tiles of 4 by 4 and its Cholesky factor, which takes the matrix's place. Method: left-looking, tile by tile;
// what is zero by structure costs nothing. Sums are in the order of the columns whatever the processor has, so all processors
// give the same bits.

#include <cstddef>
#include <cstdint>
#include <vector>

namespace trundle {

class TileMatrix {
public:
    static constexpr unsigned kTile = 4;
    [[nodiscard]] static unsigned padded(unsigned rows) { return (rows + kTile - 1) / kTile * kTile; }

    /// All zero. `full`: without a look at what stays zero; for few rows that is cheaper.
    void start(unsigned rows, bool full);
    /// Of the lower triangle: row >= column.
    void set(unsigned row, unsigned column, double value) {
        if (!isFilled(row / kTile, column / kTile)) fill(row / kTile, column / kTile);
        m_tiles[indexOf(row, column)] = value;
    }
    /// Of a full matrix: where a row begins; its next column is `kTile` values on.
    [[nodiscard]] double* rowOf(unsigned row) { return m_tiles.data() + indexOf(row, 0); }
    [[nodiscard]] double atInFull(unsigned row, unsigned column) const { return m_tiles[indexOf(row, column)]; }
    [[nodiscard]] double at(unsigned row, unsigned column) const {
        return isFilled(row / kTile, column / kTile) ? m_tiles[indexOf(row, column)] : 0;
    }
    /// Eliminates the first rows (a multiple of the tile): the rest becomes what remains of it. False where that is not positive
    /// definite.
    [[nodiscard]] bool eliminate(unsigned rows);
    /// Of rows eliminated: x such that the factor, transposed, times x is zero there, with x given from `end` on. `begin`: a multiple of
    /// the tile.
    void solveBack(unsigned begin, unsigned end, double* x) const;

    /// How the loops over tiles see it.
    struct Data {
        double* tiles;         ///< row after row, each tile column after column; on the diagonal of a factor 1 / its value
        std::uint64_t* filled; ///< a bit for each tile of a row
        unsigned rows, words;  ///< tiles; words of a row in `filled`
    };

private:
    [[nodiscard]] static std::size_t rowStart(std::size_t row) { return row * (row + 1) / 2; }
    [[nodiscard]] static std::size_t indexOf(unsigned row, unsigned column) {
        return (rowStart(row / kTile) * kTile + column) * kTile + row % kTile;
    }
    [[nodiscard]] bool isFilled(unsigned row, unsigned column) const {
        return m_filled[std::size_t(row) * m_words + column / 64] >> column % 64 & 1;
    }
    void fill(unsigned row, unsigned column);
    void fillIn(unsigned eliminated);

    std::vector<double> m_tiles;
    std::vector<std::uint64_t> m_filled;
    unsigned m_rows = 0, m_words = 0;
    bool m_full = false;
};

} // namespace trundle
