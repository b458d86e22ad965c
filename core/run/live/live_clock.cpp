#include "run/live/live_clock.h"

#include <algorithm>

namespace trundle {
namespace {

constexpr std::chrono::milliseconds kLateEnough(250), kSampleGap(20);
constexpr std::chrono::seconds kWindow(1);
constexpr double kNever = 1e9; // s, some thirty years: the clock has no more room

double secondsOf(std::chrono::steady_clock::duration d) { return std::chrono::duration<double>(d).count(); }

} // namespace

void LivePace::restart(Clock::time_point now) {
    m_start = now;
    m_done = 0;
}

LivePace::Clock::time_point LivePace::due(Clock::time_point now, double tickS, double speed) {
    if (speed != m_speed) {
        m_speed = speed;
        restart(now);
    }
    if (speed <= 0) return now;
    const double seconds = std::min(static_cast<double>(m_done + 1) * tickS / speed, kNever);
    const Clock::time_point due = m_start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));
    if (now - due < kLateEnough) return due;
    restart(now);
    return now;
}

void RunTiming::restart(Clock::time_point now, double time) { m_samples = {{now, time}}; }

void RunTiming::ticked(Clock::duration took) {
    m_spent += took;
    ++m_count;
}

double RunTiming::realTimeFactor(Clock::time_point now, double time) {
    if (m_samples.empty()) return 0;
    while (m_samples.size() > 1 && now - m_samples[1].wall >= kWindow) m_samples.pop_front();
    const Sample& first = m_samples.front();
    const double wall = secondsOf(now - first.wall);
    if (now - m_samples.back().wall >= kSampleGap) m_samples.push_back({now, time});
    return wall > 0 ? (time - first.time) / wall : 0;
}

double RunTiming::takeStepMs() {
    if (m_count > 0) m_stepMs = secondsOf(m_spent) * 1e3 / static_cast<double>(m_count);
    m_spent = {};
    m_count = 0;
    return m_stepMs;
}

} // namespace trundle
