#include "run/schedule.h"

#include <charconv>
#include <cmath>

namespace trundle {

namespace {
constexpr double kMaxTicks = 9.0e18; // below 2^63
}

std::uint64_t ticksFor(double duration, double tick) { return firstTickAt(duration, tick); }

std::uint64_t firstTickAt(double time, double tick) {
    const double exact = time / tick;
    // Tolerates two rounding errors: of the product k * period and of this division.
    const double ticks = std::ceil(exact - (1e-9 + exact * 4.5e-16));
    if (!(ticks > 0)) return 0;
    return ticks < kMaxTicks ? static_cast<std::uint64_t>(ticks) : static_cast<std::uint64_t>(kMaxTicks);
}

double tickTime(std::uint64_t ticks, double tick) {
    const double product = static_cast<double>(ticks) * tick;
    char digits[64];
    const auto written = std::to_chars(digits, digits + sizeof digits, product, std::chars_format::general, 15);
    double rounded = product;
    if (written.ec == std::errc{}) std::from_chars(digits, written.ptr, rounded);
    return rounded;
}

double nearestTickTime(double time, double tick) { return tickTime(static_cast<std::uint64_t>(std::llround(time / tick)), tick); }

bool Schedule::due(std::uint64_t tick) {
    if (!(m_period > m_tick)) return true;
    if (tick < m_next) return false;
    // The period is longer than a tick: one step per call, unless ticks were skipped.
    while (m_next <= tick) m_next = firstTickAt(static_cast<double>(++m_count) * m_period, m_tick);
    return true;
}

} // namespace trundle
