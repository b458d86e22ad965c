#pragma once
// Private to core/check.

#include <cstddef>
#include <numeric>
#include <vector>

#include "model/joint_spec.h"

namespace trundle {

/// Bodies that joints connect; the world is one more of them.
class BodyGroups {
public:
    explicit BodyGroups(std::size_t bodies) : m_parent(bodies + 1) {
        std::iota(m_parent.begin(), m_parent.end(), std::size_t(0));
    }

    /// By an index, or kWorldBody.
    [[nodiscard]] std::size_t of(int body) {
        std::size_t b = body == kWorldBody ? m_parent.size() - 1 : static_cast<std::size_t>(body);
        while (m_parent[b] != b) b = m_parent[b] = m_parent[m_parent[b]];
        return b;
    }
    /// False if they are connected already.
    bool join(int a, int b) {
        const std::size_t x = of(a), y = of(b);
        m_parent[x] = y;
        return x != y;
    }

private:
    std::vector<std::size_t> m_parent;
};

} // namespace trundle
