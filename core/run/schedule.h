#pragma once
// When something periodic is due: at the first tick with t >= k * period, counted in whole ticks so that rounding never shifts a row.

#include <cstdint>

namespace trundle {

/// The first tick n with n * tick >= time, forgiving the rounding of `time / tick`.
[[nodiscard]] std::uint64_t firstTickAt(double time, double tick);
/// Simulated time after `ticks` ticks as people write it: 0.07, not 0.07000000000000001.
[[nodiscard]] double tickTime(std::uint64_t ticks, double tick);

/// Asked once per tick with rising tick numbers.
class Schedule {
public:
    /// Seconds. A period of 0, or one not above the tick, is due at every tick.
    Schedule(double period, double tick) : m_period(period), m_tick(tick) {}
    [[nodiscard]] bool due(std::uint64_t tick);

private:
    double m_period, m_tick;
    std::uint64_t m_count = 0;
    std::uint64_t m_next = 0; // the tick of number m_count
};

} // namespace trundle
