// Method: a request is handed over by the turn word of the control page. While the host works, this side polls for a moment, then
// sleeps in slices of a millisecond and looks whether the host has ended or takes too long.
#include "control/host/host_connection.h"

#include <algorithm>
#include <csignal>
#include <new>
#include <thread>

#include "control/python_kinds.h"

namespace trundle {
namespace {

constexpr int kSliceMs = 1;
constexpr std::chrono::milliseconds kWatchAfter(50), kStackWait(200);
constexpr double kLimitAtEndS = 1;
constexpr std::size_t kLongestRecord = 16u << 20;
constexpr int kMostReportMs = 100;

/// A copy of what a fault handler has written.
std::string textOf(const std::array<char, sizeof(ControlPage::report)>& bytes) {
    const auto copy = bytes;
    return {copy.begin(), std::find(copy.begin(), copy.end(), '\0')};
}

} // namespace

HostConnection::HostConnection(SharedSegment control, ControlPage& page, Watch watch)
    : MessageLink(page, Turn::Run), m_control(std::move(control)), m_watch(std::move(watch)) {}

Result<std::unique_ptr<HostConnection>> HostConnection::start(const HostPrograms& programs, const std::string& library,
                                                              std::uint64_t generation, Watch watch) {
    Result<SharedSegment> control = SharedSegment::create("trundle-control", sizeof(ControlPage));
    if (!control) return control.error();
    auto* page = new (control.value().data()) ControlPage;
    page->generation = generation;
    std::unique_ptr<HostConnection> made(new HostConnection(std::move(control).value(), *page, std::move(watch)));
    Result<SharedSegment> sensors = SharedSegment::create("trundle-sensors", 0),
                          commands = SharedSegment::create("trundle-commands", 0);
    if (!sensors) return sensors.error();
    if (!commands) return commands.error();
    made->m_sensors = std::move(sensors).value();
    made->m_commands = std::move(commands).value();
    made->m_isPython = isPythonModule(library);
    Result<HelperProcess> process = HelperProcess::start(
        programs.host, {made->m_control.descriptor(), made->m_sensors.readOnlyDescriptor(), made->m_commands.descriptor()},
        made->m_isPython ? std::vector<std::string>{programs.python} : std::vector<std::string>{});
    if (!process) return process.error();
    made->m_process = std::move(process).value();
    return made;
}

Status HostConnection::map(std::size_t slots, const Records& records) {
    const std::size_t bytes = std::max<std::size_t>(slots, 1) * sizeof(double);
    if (Status sized = m_sensors.resize(bytes); !sized) return sized;
    if (Status sized = m_commands.resize(bytes); !sized) return sized;
    Status mapped = Error{Code::SystemRefused, "the host process cannot map its signals"};
    const auto take = [&](HostRecord record, std::uint32_t controller, WireReader& reader) {
        if (record != HostRecord::Done) return records(record, controller, reader);
        mapped = reader.status();
        return std::string();
    };
    if (!call(HostRequest::Map, WireWriter().number<std::uint64_t>(slots).view(), take)) return mapped;
    return mapped;
}

bool HostConnection::begin(HostRequest request, std::string_view bytes) {
    if (m_end) return false;
    const auto kind = static_cast<std::uint32_t>(request);
    m_since = Clock::now();
    if (!append({reinterpret_cast<const char*>(&kind), sizeof kind}) || !append(bytes)) return false;
    finishMessage();
    return true;
}

bool HostConnection::complete(const Records& records) {
    if (hasTurn()) m_since = Clock::now(); // it has answered, or asks: what other hosts took meanwhile is not its own time
    std::string stream;
    for (bool done = false; !done;) {
        bool more = false;
        if (!receivePart(stream, more)) {
            drain(stream);
            (void)handle(stream, records, done); // what it printed before its end
            return false;
        }
        if (!handle(stream, records, done)) {
            close(HostEnd::Cause::Damaged);
            return false;
        }
        if (more) askForMore();
    }
    return true;
}

/// Handles the complete records at the start of the stream and removes them. False: it is damaged.
bool HostConnection::handle(std::string& stream, const Records& records, bool& done) {
    std::size_t at = 0;
    while (stream.size() - at >= sizeof(RecordHeader)) {
        RecordHeader header;
        std::copy_n(stream.data() + at, sizeof header, reinterpret_cast<char*>(&header));
        if (header.bytes > kLongestRecord) return false;
        if (stream.size() - at - sizeof header < header.bytes) break;
        WireReader reader(std::string_view(stream).substr(at + sizeof header, header.bytes));
        at += sizeof header + header.bytes;
        const auto kind = static_cast<HostRecord>(header.kind);
        const std::string reply = records(kind, header.controller, reader);
        if (!reader.ok()) return false;
        done = kind == HostRecord::Done;
        if (header.kind < static_cast<std::uint32_t>(HostRecord::OpenLog)) continue;
        if (at != stream.size() || m_end) return false; // nothing follows a record that waits for its reply
        if (!append(reply)) return true;
        finishMessage();
    }
    stream.erase(0, at);
    return true;
}

HostCall HostConnection::current() const {
    const std::uint32_t phase = m_page.phase.load();
    return {phase <= static_cast<std::uint32_t>(HostPhase::Sense) ? static_cast<HostPhase>(phase) : HostPhase::None,
            m_page.controller.load()};
}

bool HostConnection::awaitTurn() {
    if (m_end) return false;
    if (pollTurn()) return !isOverdue(); // a controller may print without end
    while (!hasTurn()) {
        sleepForTurn(kSliceMs);
        if (hasTurn()) break;
        if (m_process.hasEnded()) {
            close(m_process.exit().bySignal ? HostEnd::Cause::Killed : HostEnd::Cause::Exit);
            return false;
        }
        if (isOverdue()) return false;
    }
    return true;
}

bool HostConnection::isOverdue() {
    const HostCall now = current();
    const bool ends = m_watch.endAsked();
    if (now.controller != m_watched.controller || now.phase != m_watched.phase || ends != m_ends) m_since = Clock::now();
    m_watched = now;
    m_ends = ends;
    const auto waited = Clock::now() - m_since;
    if (waited < kWatchAfter) return false;
    const double seconds = std::chrono::duration<double>(waited).count(), limit = ends ? kLimitAtEndS : m_watch.limits(now);
    m_watch.waiting(now, seconds);
    if (limit <= 0 || seconds < limit) return false;
    if (m_process.isTraced()) { // a debugger
        m_since = Clock::now();
        return false;
    }
    close(HostEnd::Cause::NotResponding, limit);
    return true;
}

/// Python writes the calls in progress on this signal, also in an endless loop.
void HostConnection::requestReport() {
    m_process.send(SIGUSR1);
    std::string before, now;
    for (int i = 0; i < kMostReportMs && (now.empty() || now != before) && !m_process.hasEnded(); ++i) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        before = std::exchange(now, textOf(m_page.report));
    }
}

/// The host records where a call is that does not return, as in a crash, unless the module keeps it from that.
void HostConnection::takeStack() {
    if (!m_process.receives(SIGABRT)) return;
    m_process.signalMainThread(SIGABRT);
    const Clock::time_point until = Clock::now() + kStackWait;
    while (!m_process.hasEnded() && Clock::now() < until) std::this_thread::sleep_for(std::chrono::milliseconds(kSliceMs));
}

void HostConnection::close(HostEnd::Cause cause, double limitS) {
    HostEnd end;
    end.cause = cause;
    end.during = current();
    end.limitS = limitS;
    end.afterRequest = m_ends;
    if (cause == HostEnd::Cause::NotResponding) m_isPython ? requestReport() : takeStack();
    m_process.kill();
    end.code = m_process.exit().code;
    const CrashRecord& crash = m_page.crash;
    if (crash.complete.load() != 0 && (cause == HostEnd::Cause::Killed || cause == HostEnd::Cause::Exit)) {
        end.cause = crash.signal != 0 ? HostEnd::Cause::Crash : HostEnd::Cause::Exit;
        end.code = crash.signal != 0 ? crash.signal : -1;
        end.ofThread = crash.ofThread != 0;
        end.ofSensorImage = crash.ofSensorImage != 0;
    }
    end.report = textOf(m_page.report);
    if (m_isPython && cause == HostEnd::Cause::Killed && end.report.starts_with("Fatal Python error")) end.cause = HostEnd::Cause::Crash;
    for (std::uint32_t i = 0, count = std::min<std::uint32_t>(crash.frameCount, CrashRecord::kMostFrames); i < count; ++i)
        end.frames.emplace_back(crash.frames[i].library, crash.frames[i].offset);
    const auto text = crash.exception;
    end.exception.assign(text.data(), std::find(text.begin(), text.end(), '\0'));
    m_end = std::move(end);
}

} // namespace trundle
