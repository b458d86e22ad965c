#pragma once
// The run's own side of a LiveRun. Runner, world and controllers are made, used and destroyed on its thread alone.

#include <string>

#include "run/live_clock.h"
#include "run/live_run_shared.h"

namespace trundle {

class LiveThread {
public:
    LiveThread(std::shared_ptr<LiveRun::Shared> shared, LogLocation logFolder)
        : m_shared(std::move(shared)), m_logFolder(std::move(logFolder)) {}
    LiveThread& after(std::shared_ptr<LiveRun::Shared> former, std::chrono::milliseconds patience) {
        m_after = std::move(former);
        m_patience = patience;
        return *this;
    }

    /// From building to the closed logs. Nothing that is thrown leaves it.
    void go(RunnerMaker maker);

private:
    enum class Next { Tick, Show, Stop };

    void build(const RunnerMaker& maker);
    void waitForFormer();
    void say(LiveLine line);
    void loop();
    [[nodiscard]] Next awaitNext();
    [[nodiscard]] bool tick();
    [[nodiscard]] bool atEnd() const { return m_runner->finished() || (m_ticks > 0 && m_runner->world().ticks() >= m_ticks); }
    void passWarnings();
    void publish(bool stands);
    [[nodiscard]] std::shared_ptr<const LiveSnapshot> look(bool stands, bool contacts);
    [[nodiscard]] bool holdAtDuration();
    [[nodiscard]] LiveEnd endNow() const;
    void end();
    void fail(const std::string& why);
    void tellChanged();

    std::shared_ptr<LiveRun::Shared> m_shared, m_after;
    std::chrono::milliseconds m_patience{0};
    LogLocation m_logFolder;
    std::unique_ptr<Runner> m_runner;
    Medium* m_medium = nullptr;      ///< of its world; null without radios
    std::uint64_t m_ticks = 0;       ///< of the whole run; 0: until stopped
    LiveClock::time_point m_flushed; // when logs were
    LivePace m_pace;
    LiveMeter m_meter;
    std::vector<decltype(Command::what)> m_commands;
    std::size_t m_stampedPassed = 0, m_warningsPassed = 0;
    bool m_flows = false; ///< at its speed: m_pace counts
};

} // namespace trundle
