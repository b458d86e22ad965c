#pragma once
// Schedules periodic events: due at the first tick with t >= k * period, in whole ticks, so that rounding never shifts an event.

#include <cstdint>

namespace trundle {

/// ceil(duration / tick - 1e-9)
[[nodiscard]] std::uint64_t ticksFor(double duration, double tick);
/// The first tick n with n * tick >= time, tolerating the rounding error of `time / tick`.
[[nodiscard]] std::uint64_t firstTickAt(double time, double tick);
/// Simulated time after `ticks` ticks, rounded to its decimal value: 0.07, not 0.07000000000000001.
[[nodiscard]] double tickTime(std::uint64_t ticks, double tick);
/// The same for a time that was computed as ticks * tick.
[[nodiscard]] double nearestTickTime(double time, double tick);

/// Must be called once per tick with increasing tick numbers.
class Schedule {
public:
    /// Periods in seconds. A period of 0, or not longer than the tick, is due at every tick.
    Schedule(double period, double tick) : m_period(period), m_tick(tick) {}
    [[nodiscard]] bool due(std::uint64_t tick);

private:
    double m_period, m_tick;
    std::uint64_t m_count = 0;
    std::uint64_t m_next = 0; // the next due tick
};

} // namespace trundle
