#include "world/world_chargers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trundle {

void WorldChargers::offer(std::uint32_t device, std::uint32_t geom, double volts, double amperes) {
    if (!std::isfinite(volts) || !std::isfinite(amperes)) return;
    auto charger = std::ranges::find(m_chargers, device, &Charger::device);
    if (charger == m_chargers.end()) charger = m_chargers.insert(charger, Charger{device, {}, {}, {}, {}});
    charger->offer = {volts, std::max(amperes, 0.0)};
    if (std::ranges::count(charger->geoms, geom)) return;
    for (Charger& other : m_chargers) std::erase(other.geoms, geom);
    charger->geoms.push_back(geom);
}

const WorldChargers::Charger* WorldChargers::of(std::uint32_t geom) const {
    const auto found =
        std::ranges::find_if(m_chargers, [geom](const Charger& c) { return std::ranges::count(c.geoms, geom) > 0; });
    return found == m_chargers.end() ? nullptr : &*found;
}

TrundleOffer WorldChargers::offered(std::uint32_t geom) const {
    const Charger* charger = of(geom);
    if (!charger) return {};
    return {charger->offer.volts, charger->offer.amperes / std::max<std::uint32_t>(charger->before.takers, 1)};
}

void WorldChargers::take(std::uint32_t geom, double volts, double amperes) {
    auto* charger = const_cast<Charger*>(of(geom));
    if (!charger || !std::isfinite(volts) || !(amperes > 0)) return;
    const double current = std::min(amperes, offered(geom).amperes);
    charger->now.watts += volts * current;
    charger->now.amperes += current;
    ++charger->now.takers;
}

TrundleTaken WorldChargers::taken(std::uint32_t device) const {
    const auto found = std::ranges::find(m_chargers, device, &Charger::device);
    return found == m_chargers.end() ? TrundleTaken{} : found->before;
}

void WorldChargers::beginTick() {
    for (Charger& charger : m_chargers) charger.before = std::exchange(charger.now, {});
}

} // namespace trundle
