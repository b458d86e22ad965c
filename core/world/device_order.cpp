#include "world/device_order.h"

#include <functional>
#include <queue>

namespace trundle {

std::vector<std::uint32_t> actingOrder(const std::vector<std::vector<std::uint32_t>>& peers) {
    std::vector<std::uint32_t> waitsFor(peers.size(), 0), order;
    for (const auto& list : peers)
        for (const std::uint32_t p : list) ++waitsFor[p];
    std::priority_queue<std::uint32_t, std::vector<std::uint32_t>, std::greater<>> ready;
    for (std::uint32_t i = 0; i < peers.size(); ++i)
        if (waitsFor[i] == 0) ready.push(i);
    while (!ready.empty()) {
        const std::uint32_t next = ready.top();
        ready.pop();
        order.push_back(next);
        for (const std::uint32_t p : peers[next])
            if (--waitsFor[p] == 0) ready.push(p);
    }
    return order;
}

} // namespace trundle
