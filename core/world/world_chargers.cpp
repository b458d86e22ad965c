#include "world/world_chargers.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trundle {

constexpr double kHeadroom = 1.01;

void WorldChargers::offer(std::uint32_t device, std::uint32_t geom, double volts, double amperes) {
    if (!std::isfinite(volts) || !std::isfinite(amperes)) return;
    auto charger = std::ranges::find(m_chargers, device, &Charger::device);
    if (charger == m_chargers.end()) charger = m_chargers.insert(charger, Charger{device, {}, {}, {}, {}, {}, {}, {}});
    charger->offer = {volts, std::max(amperes, 0.0)};
    if (std::ranges::count(charger->geoms, geom)) return;
    for (Charger& other : m_chargers) std::erase(other.geoms, geom);
    charger->geoms.push_back(geom);
}

WorldChargers::Charger* WorldChargers::of(std::uint32_t geom) {
    const auto found =
        std::ranges::find_if(m_chargers, [geom](const Charger& c) { return std::ranges::count(c.geoms, geom) > 0; });
    return found == m_chargers.end() ? nullptr : &*found;
}

double WorldChargers::Charger::left() const { return std::max(std::min(share, offer.amperes - now.amperes), 0.0); }

TrundleOffer WorldChargers::offered(std::uint32_t geom) {
    Charger* charger = of(geom);
    if (!charger) return {};
    const double amperes = charger->left();
    if (!(amperes > 0)) ++charger->limited;
    return {charger->offer.volts, amperes};
}

void WorldChargers::take(std::uint32_t geom, double volts, double amperes) {
    Charger* charger = of(geom);
    if (!charger || !std::isfinite(volts) || !(amperes > 0)) return;
    const double most = charger->left(), current = std::min(amperes, most);
    if (!(current > 0)) return;
    if (current < most) charger->satisfied.push_back(current);
    else ++charger->limited;
    charger->now.watts += volts * current;
    charger->now.amperes += current;
    ++charger->now.takers;
}

/// As water finds its level: those that want less than an equal share of what is left have what they want, and a little more, so that it
/// shows when they want more.
double WorldChargers::Charger::nextShare() {
    std::ranges::sort(satisfied);
    double rest = offer.amperes;
    std::size_t sharing = satisfied.size() + limited;
    for (const double took : satisfied) {
        const double wanted = kHeadroom * took;
        if (wanted * static_cast<double>(sharing) > rest) break;
        rest -= wanted;
        --sharing;
    }
    satisfied.clear();
    limited = 0;
    return sharing > 0 ? rest / static_cast<double>(sharing) : offer.amperes;
}

TrundleTaken WorldChargers::taken(std::uint32_t device) const {
    const auto found = std::ranges::find(m_chargers, device, &Charger::device);
    return found == m_chargers.end() ? TrundleTaken{} : found->before;
}

void WorldChargers::beginTick() {
    for (Charger& charger : m_chargers) {
        charger.before = std::exchange(charger.now, {});
        charger.share = charger.nextShare();
    }
}

} // namespace trundle
