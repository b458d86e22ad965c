#include "world/ode/lcp/elimination_order.h"

#include <algorithm>
#include <bit>

namespace trundle {

std::span<const unsigned> EliminationOrder::find(std::span<const std::uint64_t> pattern, unsigned rows, unsigned words) {
    m_words = words;
    m_pattern.assign(pattern.begin(), pattern.end());
    m_degrees.resize(rows);
    m_order.clear();
    m_left.resize(rows);
    for (unsigned i = 0; i < rows; ++i) {
        m_left[i] = i;
        m_degrees[i] = 0;
        for (unsigned w = 0; w < words; ++w)
            m_degrees[i] += static_cast<unsigned>(std::popcount(m_pattern[std::size_t(i) * words + w]));
    }
    while (!m_left.empty()) {
        take(*std::ranges::min_element(m_left, {}, [this](unsigned i) { return m_degrees[i]; }));
        std::erase_if(m_left, [this](unsigned i) { return m_degrees[i] == 0; });
    }
    return m_order;
}

/// With all whose connections are among those of `row`.
void EliminationOrder::take(unsigned row) {
    const std::uint64_t* const reach = m_pattern.data() + std::size_t(row) * m_words;
    m_taken.assign(m_words, 0);
    const auto forEach = [&](auto&& visit) {
        for (const unsigned i : m_left)
            if (reach[i / 64] >> i % 64 & 1) visit(i, m_pattern.data() + std::size_t(i) * m_words);
    };
    forEach([&](unsigned i, const std::uint64_t* own) {
        for (unsigned w = 0; w < m_words; ++w)
            if (own[w] & ~reach[w]) return;
        m_order.push_back(i);
        m_degrees[i] = 0;
        m_taken[i / 64] |= std::uint64_t(1) << i % 64;
    });
    forEach([&](unsigned i, std::uint64_t* own) {
        if (m_degrees[i] == 0) return;
        m_degrees[i] = 0;
        for (unsigned w = 0; w < m_words; ++w) {
            own[w] = (own[w] | reach[w]) & ~m_taken[w];
            m_degrees[i] += static_cast<unsigned>(std::popcount(own[w]));
        }
    });
}

} // namespace trundle
