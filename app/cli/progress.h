#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace trundle {

/// What standard error shows while a run goes on: a bar on a terminal, a plain line now and then otherwise. Lines of others that go to
/// standard error during the run pass through line(), so that the bar stays below them.
class Progress {
public:
    /// `ticks` 0: the end is not known. A hidden one prints only lines.
    Progress(std::uint64_t ticks, double tick, bool hidden);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Called after each tick; shows something only every so often.
    void update(std::uint64_t ticks);
    /// The last state of things.
    void finish(std::uint64_t ticks);
    /// Text that ends in a line end.
    void line(const std::string& text);

private:
    using Clock = std::chrono::steady_clock;

    std::string stateText(std::uint64_t ticks, double wallS) const;
    void show(std::uint64_t ticks);
    void clearBar();

    std::uint64_t m_total;
    double m_tick;
    bool m_hidden, m_terminal, m_barShown = false, m_finished = false;
    Clock::time_point m_start, m_next;
};

} // namespace trundle
