#include "radio/radio_figures.h"

#include <algorithm>
#include <cmath>

#include "base/rng.h"

namespace trundle {

namespace {

constexpr std::uint64_t kPowerSalt = 0x504f57, kReadingSalt = 0x524541, kClockSalt = 0x434c4f;

double normalOf(std::uint64_t seed, std::uint64_t key, std::uint64_t salt) {
    return toNormal(randomBits(seed, key, salt, 0), randomBits(seed, key, salt, 1));
}

} // namespace

RadioOffsets offsetsOf(const MediumSettings& settings, std::uint64_t key) {
    return {settings.offsets * normalOf(settings.seed, key, kPowerSalt),
            settings.offsets * normalOf(settings.seed, key, kReadingSalt),
            1 + 1e-6 * settings.clockDrift * normalOf(settings.seed, key, kClockSalt)};
}

double outputLevel(const RadioDefinition& radio, double wanted) {
    const double power = std::min(wanted, radio.maxOutputPower);
    if (radio.powerLevels.empty()) return power;
    double best = *std::min_element(radio.powerLevels.begin(), radio.powerLevels.end());
    for (const double level : radio.powerLevels)
        if (level <= power + 1e-9) best = std::max(best, level);
    return best;
}

double rssiOf(const RadioDefinition& radio, double power) {
    const double step = radio.rssiStep, most = radio.maxReceivePower;
    if (!(step > 0)) return std::min(power, most);
    return std::min(std::round(power / step), std::floor(most / step + 1e-9)) * step; // 1e-9: a limit that is a multiple itself
}

} // namespace trundle
