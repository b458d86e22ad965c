#pragma once
// Wall-clock pacing and timing of a live run. None of this affects the simulation.

#include <chrono>
#include <cstdint>
#include <deque>

namespace trundle {

/// The due time of each tick at a given speed.
class LivePace {
public:
    using Clock = std::chrono::steady_clock;

    /// Restarts the schedule: the next tick is due one tick period after `now`.
    void restart(Clock::time_point now);
    /// The due time of the coming tick of `tickS` simulated seconds. If the schedule is more than 0.25 s late, the tick is due
    /// now and the lost time is not caught up.
    [[nodiscard]] Clock::time_point due(Clock::time_point now, double tickS, double speed);
    void ticked() { ++m_done; }

private:
    Clock::time_point m_start;
    std::uint64_t m_done = 0;
    double m_speed = -1;
};

/// Measures the speed of a run.
class RunTiming {
public:
    using Clock = std::chrono::steady_clock;

    void restart(Clock::time_point now, double time);
    void ticked(Clock::duration took);
    /// Simulated time per wall time over about the last second.
    [[nodiscard]] double realTimeFactor(Clock::time_point now, double time);
    /// Mean wall time per tick since the last call, ms; the previous value if there were no ticks.
    [[nodiscard]] double takeStepMs();

private:
    struct Sample {
        Clock::time_point wall;
        double time;
    };
    std::deque<Sample> m_samples;
    Clock::duration m_spent{};
    std::uint64_t m_count = 0;
    double m_stepMs = 0;
};

} // namespace trundle
