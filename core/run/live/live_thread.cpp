#include "run/live/live_thread.h"

#include <algorithm>
#include <exception>

#include <trundle/abi.h>

#include "base/platform/memory.h"
#include "base/platform/recent_runs.h"
#include "radio/medium.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxLines = 10'000;           // limit for waiting console lines
constexpr std::chrono::milliseconds kGuestWait(5);  // a guest is served at least so often
constexpr std::chrono::milliseconds kFlushGap(200); // at most this much of the logs is lost in a crash

std::shared_ptr<const std::vector<LiveContact>> copied(const std::vector<WorldContact>& contacts) {
    auto list = std::make_shared<std::vector<LiveContact>>();
    list->reserve(contacts.size());
    for (const WorldContact& c : contacts)
        list->push_back({std::string(c.first), std::string(c.second), c.position, c.normal, c.depth, c.force});
    return list;
}

} // namespace

void LiveThread::go(RunnerMaker maker) {
    const RunOfThread monitored(m_shared->calls);
    try {
        waitForPrevious();
        build(maker);
        if (m_runner) loop();
        m_guest.leave();
        end();
    } catch (const std::exception& e) { fail(reasonOf(e)); } catch (...) {
        fail("something was thrown that is no std::exception");
    }
    m_guest.leave();
    m_runner.reset();
    maker = nullptr; // releases everything that it captured
    std::function<void()> changed;
    {
        const std::scoped_lock guard(m_shared->lock);
        m_shared->busySince.reset();
        m_shared->gone = true;
        changed = m_shared->changed;
        m_shared->ends.notify_all();
    }
    if (changed) changed();
}

/// Two runs must not write the same logs at the same time.
void LiveThread::waitForPrevious() {
    if (!m_after) return;
    {
        std::unique_lock guard(m_after->lock);
        if (m_after->ends.wait_for(guard, m_timeout, [&] { return m_after->gone; })) return m_after.reset();
    }
    m_after.reset();
    m_logFolder = {};
    addMessage({0, "", TRUNDLE_WARNING,
                "the previous run has not ended: one of its controllers is not responding. This run writes no logs"});
}

void LiveThread::addMessage(LiveLine line) {
    if (m_guest.isTaken()) m_guest->addLine(line);
    const std::scoped_lock guard(m_shared->lock);
    if (m_shared->lines.size() >= kMaxLines) {
        m_shared->lines.pop_front();
        ++m_shared->dropped;
    }
    m_shared->lines.push_back(std::move(line));
}

void LiveThread::build(const RunnerMaker& maker) {
    RunOptions options;
    options.logFolder = m_logFolder;
    options.calls = m_shared->calls;
    options.measuresControllers = true;
    // `this` outlives the runner, which is used on this thread only.
    options.console = [this](double time, const std::string& who, int severity, const std::string& text) {
        addMessage({time, who, severity, text});
    };
    Diagnostics problems;
    m_runner = maker(std::move(options), problems);
    if (!m_runner) {
        LiveEnd end;
        end.problems = problems.all();
        for (const Diagnostic& problem : end.problems)
            if (problem.severity == Severity::Error && !end.failure) end.failure = problem;
        if (!end.failure) end.failure = Diagnostic{Severity::Error, Code::Internal, "nothing could be built", {}, {}, {}, {}};
        const std::scoped_lock guard(m_shared->lock);
        m_shared->end = std::move(end);
        return;
    }
    const World& world = m_runner->world();
    if (Medium* medium = world.medium(); medium && medium->radioCount() > 0) {
        m_medium = medium;
        m_shared->radio.open(*medium);
    }
    const SettingsSpec& settings = world.experiment().settings;
    m_ticks = settings.duration > 0 ? ticksFor(settings.duration, settings.tick) : 0;
    m_pace.restart(LiveClock::now());
    m_meter.restart(LiveClock::now(), 0);
    auto layout = std::make_shared<const SignalLayout>(world.layout());
    auto first = look(true, true);
    {
        const std::scoped_lock guard(m_shared->lock);
        m_shared->layout = std::move(layout);
        m_shared->snapshot = std::move(first);
        m_shared->warnings = problems.all();
        m_shared->phase = m_shared->running || m_shared->steps > 0 ? LivePhase::Running : LivePhase::Paused;
        m_shared->busySince.reset();
    }
    passWarnings();
    notifyChanged();
}

void LiveThread::loop() {
    while (!atEnd() || holdAtDuration()) {
        m_guest.serve(*m_shared, *m_runner);
        switch (awaitNext()) {
        case NextStep::Stop: return;
        case NextStep::Show: publish(true); break;
        case NextStep::Serve: break;
        case NextStep::Tick:
            if (!tick()) return;
            break;
        }
    }
}

/// Reports the end by Duration if the run can continue from there. False if the end is final.
bool LiveThread::holdAtDuration() {
    if (m_runner->finished()) return false;
    m_runner->flushLogs();
    publishLast();
    {
        const std::scoped_lock guard(m_shared->lock);
        if (!m_shared->canContinue || m_shared->stop || m_runner->failure()) return false;
        m_ticks = 0; // no limit from here on
        m_shared->running = false;
        m_shared->steps = 0;
        m_shared->end = endNow();
        m_shared->end->canContinue = true;
        m_shared->phase = LivePhase::Ended;
    }
    notifyChanged();
    return true;
}

/// Waits until there is something to do, at most for a while if there is a guest. For a tick, moves the pending commands to m_commands.
LiveThread::NextStep LiveThread::awaitNext() {
    const double tickS = m_runner->world().experiment().settings.tick;
    std::unique_lock guard(m_shared->lock);
    for (;;) {
        if (m_shared->stop) return NextStep::Stop;
        const bool runs = m_shared->running;
        if (!runs) m_paced = false;
        if (!runs && m_shared->steps == 0) {
            const bool stops = m_shared->phase == LivePhase::Running; // publish() sets the phase together with the snapshot
            if (std::exchange(m_shared->showAgain, false) || stops) return NextStep::Show;
            if (m_shared->guest) return NextStep::Serve;
            if (m_guest.isTaken()) {
                m_shared->wake.wait_for(guard, kGuestWait);
                return NextStep::Serve;
            }
            m_shared->wake.wait(guard);
            continue;
        }
        const LiveClock::time_point now = LiveClock::now();
        if (runs && !m_paced) {
            m_paced = true;
            m_pace.restart(now);
            m_meter.restart(now, m_runner->world().time());
        }
        m_shared->end.reset();
        if (std::exchange(m_shared->phase, LivePhase::Running) != LivePhase::Running &&
            runs) { // a single tick is reported when it is done
            guard.unlock();
            notifyChanged();
            guard.lock();
            continue;
        }
        if (runs) {
            const LiveClock::time_point due = m_pace.due(now, tickS, m_shared->speed);
            if (due > now) {
                m_shared->wake.wait_until(guard, m_guest.isTaken() ? std::min(due, now + kGuestWait) : due);
                if (m_guest.isTaken() || m_shared->guest) return NextStep::Serve;
                continue;
            }
        }
        m_commands = std::exchange(m_shared->commands, {});
        if (m_shared->push) m_commands.emplace_back(*m_shared->push);
        m_shared->busySince = now;
        return NextStep::Tick;
    }
}

/// Executes one tick. False if it failed.
bool LiveThread::tick() {
    for (auto& what : std::exchange(m_commands, {})) m_runner->command(std::move(what));
    if (m_guest.isTaken()) m_guest->beforeTick();
    const LiveClock::time_point before = LiveClock::now();
    if (before - m_flushed >= kFlushGap) {
        m_runner->flushLogs();
        m_flushed = before;
    }
    if (m_medium) m_shared->radio.beforeTick(*m_medium);
    const bool good = m_runner->tick().ok();
    if (m_medium) m_shared->radio.afterTick(*m_medium);
    if (m_guest.isTaken()) m_guest->afterTick(good);
    const LiveClock::time_point after = LiveClock::now();
    m_meter.ticked(after - before);
    m_pace.ticked();
    bool shows = false, stepped = false;
    {
        const std::scoped_lock guard(m_shared->lock);
        m_shared->busySince.reset();
        if (m_shared->steps > 0 && !m_shared->running) {
            --m_shared->steps;
            stepped = m_shared->steps == 0;
        }
        const std::vector<Command>& all = m_runner->commands();
        m_shared->stamped.insert(m_shared->stamped.end(), all.begin() + static_cast<std::ptrdiff_t>(m_stampedPassed), all.end());
        m_stampedPassed = all.size();
        shows = m_shared->fetched;
    }
    if (!good) return false;
    if (atEnd()) return true;
    if (stepped) publish(true);
    else if (shows) publish(false);
    return true;
}

void LiveThread::passWarnings() {
    const std::vector<Diagnostic>& all = m_runner->warnings();
    if (m_warningsPassed == all.size()) return;
    const std::scoped_lock guard(m_shared->lock);
    m_shared->warnings.insert(m_shared->warnings.end(), all.begin() + static_cast<std::ptrdiff_t>(m_warningsPassed), all.end());
    m_warningsPassed = all.size();
}

std::shared_ptr<const LiveSnapshot> LiveThread::look(bool stands, bool contacts) {
    const World& world = m_runner->world();
    auto shot = std::make_shared<LiveSnapshot>();
    auto block = std::make_shared<SignalBlock>(world.layout());
    block->copyFrom(world.block());
    shot->block = std::move(block);
    shot->tick = world.ticks();
    shot->time = world.time();
    shot->quickTicks = world.solves().quickTicks;
    shot->engine = world.experiment().settings.engine;
    shot->threads = threadsFor(world.experiment());
    shot->realTimeFactor = m_meter.realTimeFactor(LiveClock::now(), shot->time);
    if (stands) shot->realTimeFactor = 0;
    shot->stepMs = m_meter.takeStepMs();
    const std::vector<WorldContact>& touching = world.contacts();
    shot->contactCount = touching.size();
    shot->ended = world.robotFaults().ends;
    shot->stopped = m_runner->stoppedControllers();
    shot->costs = m_runner->controllerCosts();
    shot->images = m_runner->cameras().images();
    if (contacts) shot->contacts = copied(touching);
    if (stands) shot->hash = world.stateHash();
    return shot;
}

void LiveThread::publish(bool stands) {
    bool contacts = false;
    {
        const std::scoped_lock guard(m_shared->lock);
        contacts = m_shared->contacts;
    }
    auto shot = look(stands, contacts);
    if (stands) m_runner->flushLogs(); // users may read the logs while paused
    {
        const std::scoped_lock guard(m_shared->lock);
        m_shared->snapshot = std::move(shot);
        m_shared->fetched = false;
        if (stands && !m_shared->running && m_shared->steps == 0 && !m_shared->end) m_shared->phase = LivePhase::Paused;
    }
    passWarnings(); // after the snapshot that they are about
    if (stands) notifyChanged();
}

/// The state at an end, and the warnings up to there: who sees that the run has ended finds them complete.
void LiveThread::publishLast() {
    auto shot = look(true, true);
    {
        const std::scoped_lock guard(m_shared->lock);
        m_shared->snapshot = std::move(shot);
        m_shared->fetched = false;
    }
    passWarnings(); // after the snapshot that they are about
}

LiveEnd LiveThread::endNow() const {
    LiveEnd end;
    end.time = m_runner->world().time();
    if (const Diagnostic* failure = m_runner->failure()) end.failure = *failure;
    if (const RunFinish* finish = m_runner->finished()) end.finish = *finish;
    if (const Fault* fault = m_runner->world().fault()) {
        end.body = fault->body;
        end.time = fault->time;
    }
    end.logFiles = m_runner->logFiles();
    return end;
}

/// Closes the logs, then reports the end.
void LiveThread::end() {
    std::optional<LiveEnd> end;
    if (m_runner) {
        (void)m_runner->finish(); // a failure is reported by failure()
        end = endNow();
        publishLast();
    }
    {
        const std::scoped_lock guard(m_shared->lock);
        if (end) m_shared->end = std::move(end);
        m_shared->phase = LivePhase::Ended;
    }
    notifyChanged();
}

void LiveThread::fail(const std::string& why) {
    {
        const std::scoped_lock guard(m_shared->lock);
        LiveEnd end;
        end.failure =
            Diagnostic{Severity::Error, Code::Internal, "the run was ended by a fault of the program: " + why, {}, {}, {}, {}};
        if (m_shared->snapshot) end.time = m_shared->snapshot->time;
        if (!m_shared->end) m_shared->end = std::move(end);
        m_shared->phase = LivePhase::Ended;
    }
    notifyChanged();
}

void LiveThread::notifyChanged() {
    std::function<void()> changed;
    {
        const std::scoped_lock guard(m_shared->lock);
        changed = m_shared->changed;
    }
    if (changed) changed();
}

} // namespace trundle
