#include "run/live/live_run.h"

#include <cmath>
#include <system_error>

#include "run/live/live_run_shared.h"
#include "run/live/live_thread.h"

namespace trundle {

LiveRun::LiveRun(RunnerMaker maker, Options options) : m_shared(std::make_shared<LiveRunShared>()) {
    m_shared->running = options.startsRunning;
    m_shared->steps = options.startsRunning ? 0 : options.steps;
    m_shared->canContinue = options.canContinue;
    m_shared->contacts = options.contacts;
    m_shared->radio.setEnabled(options.radio);
    m_shared->changed = std::move(options.changed);
    if (options.guest) m_shared->guest = std::move(options.guest);
    m_shared->busySince = LiveClock::now();
    setSpeed(options.speed);
    try {
        m_shared->thread =
            std::thread([shared = m_shared, maker = std::move(maker), folder = std::move(options.logFolder),
                         after = options.after ? options.after->m_shared : nullptr, timeout = options.timeout]() mutable {
                LiveThread(std::move(shared), std::move(folder)).after(std::move(after), timeout).go(std::move(maker));
            });
    } catch (const std::system_error&) {
        LiveEnd end;
        end.failure =
            Diagnostic{Severity::Error, Code::SystemRefused, "the system has no thread left for the run", {}, {}, {}, {}};
        m_shared->end = std::move(end);
        m_shared->phase = LivePhase::Ended;
        m_shared->gone = true;
    }
}

LiveRun::~LiveRun() {
    stop();
    if (!m_shared->thread.joinable()) return;
    // A finished thread is joined at once; a running one is detached and ends by itself.
    if (gone()) m_shared->thread.join();
    else m_shared->thread.detach();
}

void LiveRun::run() {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->running = true;
    m_shared->steps = 0;
    m_shared->wake.notify_all();
}

void LiveRun::pause() {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->running = false;
    m_shared->steps = 0;
    m_shared->wake.notify_all();
}

void LiveRun::step(std::uint64_t ticks) {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->running = false;
    m_shared->steps += ticks;
    m_shared->wake.notify_all();
}

void LiveRun::stop() {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->stop = true;
    m_shared->wake.notify_all();
}

void LiveRun::setSpeed(double factor) {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->speed = std::isfinite(factor) && factor > 0 ? std::max(factor, 1e-3) : 0;
    m_shared->wake.notify_all();
}

void LiveRun::setContactsEnabled(bool wanted) {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->showAgain = m_shared->showAgain || (wanted && !m_shared->contacts);
    m_shared->contacts = wanted;
    m_shared->wake.notify_all();
}

void LiveRun::setGuest(GuestMaker maker) {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->guest = std::move(maker);
    m_shared->wake.notify_all();
}

void LiveRun::setRadioEnabled(bool wanted) { m_shared->radio.setEnabled(wanted); }

namespace {

/// Whether the later of two commands for the same tick replaces the earlier one.
bool replaces(const decltype(Command::what)& later, const decltype(Command::what)& earlier) {
    if (later.index() != earlier.index()) return false;
    if (const auto* push = std::get_if<PushCommand>(&later)) return push->body == std::get<PushCommand>(earlier).body;
    if (const auto* place = std::get_if<PlaceCommand>(&later)) return place->robot == std::get<PlaceCommand>(earlier).robot;
    if (const auto* signal = std::get_if<SignalCommand>(&later)) {
        const auto& before = std::get<SignalCommand>(earlier);
        return signal->path == before.path && signal->element == before.element;
    }
    return false;
}

} // namespace

void LiveRun::command(decltype(Command::what) what) {
    const std::scoped_lock guard(m_shared->lock);
    if (m_shared->phase == LivePhase::Ended && !(m_shared->end && m_shared->end->canContinue)) return;
    if (std::holds_alternative<PlaceCommand>(what)) // the last one counts, also for what is joined to another one
        std::erase_if(m_shared->commands, [&](const auto& earlier) { return replaces(what, earlier); });
    for (auto& earlier : m_shared->commands)
        if (replaces(what, earlier)) {
            earlier = std::move(what);
            return;
        }
    m_shared->commands.push_back(std::move(what));
}

void LiveRun::keepPushing(std::optional<PushCommand> push) {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->push = std::move(push);
}

LiveView LiveRun::view() const {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->fetched = true;
    return {m_shared->phase, m_shared->layout, m_shared->snapshot};
}

LivePhase LiveRun::phase() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->phase;
}

bool LiveRun::gone() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->gone;
}

bool LiveRun::waitUntilGone(std::chrono::milliseconds atMost) {
    std::unique_lock guard(m_shared->lock);
    return m_shared->ends.wait_for(guard, atMost, [&] { return m_shared->gone; });
}

double LiveRun::speed() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->speed;
}

std::shared_ptr<const SignalLayout> LiveRun::layout() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->layout;
}

std::shared_ptr<const LiveSnapshot> LiveRun::snapshot() const {
    const std::scoped_lock guard(m_shared->lock);
    m_shared->fetched = true;
    return m_shared->snapshot;
}

LiveLines LiveRun::takeLines() {
    std::deque<LiveLine> lines;
    LiveLines taken;
    {
        const std::scoped_lock guard(m_shared->lock);
        lines.swap(m_shared->lines);
        taken.dropped = std::exchange(m_shared->dropped, 0);
    }
    taken.lines.assign(std::make_move_iterator(lines.begin()), std::make_move_iterator(lines.end()));
    return taken;
}

LiveRadio LiveRun::takeRadio() { return m_shared->radio.take(); }

std::vector<Diagnostic> LiveRun::takeWarnings() {
    const std::scoped_lock guard(m_shared->lock);
    return std::exchange(m_shared->warnings, {});
}

std::optional<LiveEnd> LiveRun::end() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->end;
}

std::vector<Command> LiveRun::commands() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->stamped;
}

double LiveRun::busyS() const {
    const std::scoped_lock guard(m_shared->lock);
    return m_shared->busySince ? std::chrono::duration<double>(LiveClock::now() - *m_shared->busySince).count() : 0;
}

const CallTarget* LiveRun::controllerInCall() const {
    const CallTarget* target = m_shared->calls->target();
    return target && target->controllerOf != CallTarget::kNoRobot ? target : nullptr;
}

} // namespace trundle
