#include "world/world_lamps.h"

#include <algorithm>

#include "world/engine.h"

namespace trundle {

void WorldLamps::set(std::uint32_t device, std::uint32_t body, const Vec3& point, double light) {
    auto at =
        std::lower_bound(m_lamps.begin(), m_lamps.end(), device, [](const Lamp& l, std::uint32_t d) { return l.device < d; });
    if (at == m_lamps.end() || at->device != device) {
        if (!(light > 0)) return;
        at = m_lamps.insert(at, Lamp{});
    }
    *at = {device, body, point, light};
}

std::size_t WorldLamps::write(std::span<TrundleLight> out, const Engine& engine) const {
    std::size_t count = 0;
    for (const Lamp& lamp : m_lamps) {
        if (!(lamp.light > 0) || count++ >= out.size()) continue;
        const BodyState& body = engine.state({lamp.body});
        const Vec3 at = Pose{body.position, body.rotation} * lamp.point;
        out[count - 1] = {{at.x(), at.y(), at.z()}, lamp.light, TRUNDLE_LAMP, 1};
    }
    return count;
}

} // namespace trundle
