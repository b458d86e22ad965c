#pragma once
// In which order the rows of a sparse symmetric matrix are eliminated, so that little of what is zero is filled: least degree first, and
// with a row all that are connected to nothing else. For joints in trees nothing is filled.

#include <cstdint>
#include <span>
#include <vector>

namespace trundle {

class EliminationOrder {
public:
    /// `pattern`: `rows` times `words` words, a bit for each value that is not zero; only the first `rows` columns count, in both
    /// triangles and with the diagonal. The result is valid until the next call.
    [[nodiscard]] std::span<const unsigned> find(std::span<const std::uint64_t> pattern, unsigned rows, unsigned words);

private:
    void take(unsigned row);

    unsigned m_words = 0;
    std::vector<std::uint64_t> m_pattern, m_taken;
    std::vector<unsigned> m_degrees, m_order, m_left;
};

} // namespace trundle
