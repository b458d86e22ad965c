#pragma once
// Wall time around a live run. Nothing here reaches the world: pace and figures never change a result.

#include <chrono>
#include <cstdint>
#include <deque>

namespace trundle {

/// When each tick is due at a speed.
class LivePace {
public:
    using Clock = std::chrono::steady_clock;

    /// From here on: the next tick is due one tick's time after `now`.
    void restart(Clock::time_point now);
    /// When the coming tick of `tickS` simulated seconds is due. One that is late by more than a quarter of a second is due now: lost
    /// time is not made up for by a rush.
    [[nodiscard]] Clock::time_point due(Clock::time_point now, double tickS, double speed);
    void ticked() { ++m_done; }

private:
    Clock::time_point m_start;
    std::uint64_t m_done = 0;
    double m_speed = -1;
};

/// How fast it goes.
class LiveMeter {
public:
    using Clock = std::chrono::steady_clock;

    void restart(Clock::time_point now, double time);
    void ticked(Clock::duration took);
    /// Simulated s per s over about the last second.
    [[nodiscard]] double realTimeFactor(Clock::time_point now, double time);
    /// Mean wall time of the ticks since the last call; what it was before where there were none.
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
