#include "world/world_lamps.h"

#include <algorithm>

#include "world/engine.h"
#include "world/world_device.h"

namespace trundle {

void WorldLamps::set(const WorldDevice& device, const LampMount& mount, double light) {
    const auto isBefore = [&device](const Lamp& l, int) {
        return l.pathHash != device.pathHash ? l.pathHash < device.pathHash : l.device < device.index;
    };
    auto at = std::lower_bound(m_lamps.begin(), m_lamps.end(), 0, isBefore);
    if (at == m_lamps.end() || at->device != device.index) {
        if (!(light > 0)) return;
        at = m_lamps.insert(at, Lamp{});
    }
    *at = {device.pathHash, device.index, mount, light};
}

std::size_t WorldLamps::write(std::span<TrundleLight> out, const Engine& engine) const {
    std::size_t count = 0;
    for (const Lamp& lamp : m_lamps) {
        if (!(lamp.light > 0) || count++ >= out.size()) continue;
        const BodyState& body = engine.state({lamp.mount.body});
        const Vec3 at = Pose{body.position, body.rotation} * lamp.mount.point;
        out[count - 1] = {{at.x(), at.y(), at.z()}, lamp.light, TRUNDLE_LAMP, 1};
    }
    return count;
}

std::size_t WorldLamps::writeBeams(std::span<TrundleBeam> out, const Engine& engine) const {
    std::size_t count = 0;
    for (const Lamp& lamp : m_lamps) {
        if (!(lamp.light > 0) || count++ >= out.size()) continue;
        const TrundleBeam& beam = lamp.mount.beam;
        const Vec3 axis = engine.state({lamp.mount.body}).rotation * Vec3(beam.axis);
        out[count - 1] = {{axis.x(), axis.y(), axis.z()}, beam.exponent, beam.radius};
    }
    return count;
}

} // namespace trundle
