#pragma once
// The thread of a LiveRun. Runner, world and controllers are created, used and destroyed on this thread only.

#include <string>

#include "run/live/guest_seat.h"
#include "run/live/live_clock.h"
#include "run/live/live_run_shared.h"

namespace trundle {

class LiveThread {
public:
    LiveThread(std::shared_ptr<LiveRunShared> shared, LogLocation logFolder)
        : m_shared(std::move(shared)), m_logFolder(std::move(logFolder)) {}
    LiveThread& after(std::shared_ptr<LiveRunShared> former, std::chrono::milliseconds timeout) {
        m_after = std::move(former);
        m_timeout = timeout;
        return *this;
    }

    /// The whole run, from building to closing the logs. Catches all exceptions.
    void go(RunnerMaker maker);

private:
    enum class NextStep { Tick, Show, Serve, Stop };

    void build(const RunnerMaker& maker);
    void waitForPrevious();
    void addMessage(LiveLine line);
    void loop();
    [[nodiscard]] NextStep awaitNext();
    [[nodiscard]] bool tick();
    [[nodiscard]] bool atEnd() const { return m_runner->finished() || (m_ticks > 0 && m_runner->world().ticks() >= m_ticks); }
    void passWarnings();
    void publish(bool stands);
    void publishLast();
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> look(bool stands, bool contacts);
    [[nodiscard]] bool holdAtDuration();
    [[nodiscard]] LiveEnd endNow() const;
    void end();
    void fail(const std::string& why);
    void notifyChanged();

    std::shared_ptr<LiveRunShared> m_shared, m_after;
    std::chrono::milliseconds m_timeout{0};
    LogLocation m_logFolder;
    std::unique_ptr<Runner> m_runner;
    GuestSeat m_guest;
    Medium* m_medium = nullptr;      ///< of the runner's world; null without radios
    std::uint64_t m_ticks = 0;       ///< total for the run; 0: no limit
    LiveClock::time_point m_flushed; // time of the last log flush
    LivePace m_pace;
    RunTiming m_meter;
    std::vector<decltype(Command::what)> m_commands;
    std::size_t m_stampedPassed = 0, m_warningsPassed = 0;
    bool m_paced = false; ///< running at the set speed; m_pace is valid
};

} // namespace trundle
