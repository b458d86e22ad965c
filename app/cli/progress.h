#pragma once
#include <chrono>
#include <cstdint>
#include <string>

namespace trundle {

/// Progress on standard error during a run: a bar on a terminal, otherwise an occasional plain line. Other output to standard
/// error during the run must use line(), so that the bar stays below it.
class Progress {
public:
    /// `ticks` 0: unknown end. If `hidden`, only prints the texts passed to line().
    Progress(std::uint64_t ticks, double tick, bool hidden);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    /// Called after each tick; updates the display only at intervals.
    void update(std::uint64_t ticks);
    /// Shows the final state.
    void finish(std::uint64_t ticks);
    /// Prints a text that ends with a line end.
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
