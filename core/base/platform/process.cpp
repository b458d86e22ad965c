// Runs a child process with limits. Needs: Linux. Assumes: between fork and exec only async-signal-safe calls, since other
// threads may hold locks.
// Method: pipes for output, a socket pair for input (a closed reader is then an error, not SIGPIPE), one poll loop until both
// outputs are closed or the time limit passes; then the child's process group is killed and the child is waited for.
#include "base/platform/process.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <thread>
#include <utility>

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace trundle {
namespace {

using Clock = std::chrono::steady_clock;

class Descriptor {
public:
    Descriptor() = default;
    explicit Descriptor(int file) : m_file(file) {}
    Descriptor(Descriptor&& other) noexcept : m_file(std::exchange(other.m_file, -1)) {}
    Descriptor& operator=(Descriptor&& other) noexcept {
        std::swap(m_file, other.m_file);
        return *this;
    }
    ~Descriptor() { close(); }
    void close() {
        if (m_file >= 0) ::close(std::exchange(m_file, -1));
    }
    [[nodiscard]] int file() const { return m_file; }

private:
    int m_file = -1;
};

struct Channel {
    Descriptor ours, childs;
};

bool openPipe(Channel& channel) {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return false;
    channel.ours = Descriptor(ends[0]);
    channel.childs = Descriptor(ends[1]);
    return ::fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

bool openInput(Channel& channel, bool wanted) {
    if (!wanted) {
        channel.childs = Descriptor(::open("/dev/null", O_RDONLY | O_CLOEXEC));
        return channel.childs.file() >= 0;
    }
    int ends[2];
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) return false;
    channel.ours = Descriptor(ends[0]);
    channel.childs = Descriptor(ends[1]);
    return ::fcntl(ends[0], F_SETFL, O_NONBLOCK) == 0;
}

// If our standard streams are closed, a new descriptor may be one of 0..2, which the child is about to replace.
bool liftAboveStandard(Channel& channel) {
    if (channel.childs.file() > 2) return true;
    Descriptor lifted(::fcntl(channel.childs.file(), F_DUPFD_CLOEXEC, 3));
    channel.childs = std::move(lifted);
    return channel.childs.file() > 2;
}

/// Everything the child needs, prepared before the fork.
struct ChildPlan {
    const char* program;
    char* const* arguments;
    const char* folder; ///< or nullptr
    ResourceLimits limits;
    pid_t parent;
    int input, output, errors, report;
};

[[noreturn]] void becomeChild(const ChildPlan& plan) {
    int fault = 0;
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != plan.parent) ::_exit(127); // the parent died before prctl() above
    sigset_t none;
    sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    ::signal(SIGPIPE, SIG_DFL);
    const bool ready = ::dup2(plan.input, 0) >= 0 && ::dup2(plan.output, 1) >= 0 && ::dup2(plan.errors, 2) >= 0 &&
                       (plan.folder == nullptr || ::chdir(plan.folder) == 0) && applyLimits(plan.limits);
    if (ready) ::execv(plan.program, plan.arguments);
    fault = errno;
    (void)!::write(plan.report, &fault, sizeof fault);
    ::_exit(127);
}

using Receiver = std::function<void(std::string_view)>;

/// Reads the available bytes. False at the end of the stream.
bool drain(const Descriptor& from, std::string& into, std::uint64_t most, const Receiver& received, bool& overflow) {
    char buffer[65536];
    for (;;) {
        const ssize_t got = ::read(from.file(), buffer, sizeof buffer);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return errno == EAGAIN;
        if (got == 0) return false;
        if (received) received({buffer, static_cast<std::size_t>(got)});
        const std::size_t room = most > into.size() ? static_cast<std::size_t>(most - into.size()) : 0;
        into.append(buffer, std::min(room, static_cast<std::size_t>(got)));
        overflow = overflow || static_cast<std::size_t>(got) > room;
        if (overflow) return true; // return to the caller, since a fast writer could keep this loop running
    }
}

/// Writes what fits. False if all bytes are written or the reader has closed.
bool feed(const Descriptor& to, std::string_view& rest) {
    while (!rest.empty()) {
        const ssize_t done = ::send(to.file(), rest.data(), rest.size(), MSG_NOSIGNAL);
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) return errno == EAGAIN;
        rest.remove_prefix(static_cast<std::size_t>(done));
    }
    return false;
}

int millisecondsUntil(Clock::time_point deadline) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
    return static_cast<int>(std::clamp<long long>(left, 0, 3'600'000));
}

constexpr int kStopLookMs = 50;

/// Transfers bytes until the child has closed both outputs or a limit is exceeded.
void transfer(const ProcessRequest& request, Channel& in, Channel& out, Channel& err, Clock::time_point deadline,
              ProcessResult& result) {
    std::string_view rest = request.input;
    bool ignored = false, tooMuch = false;
    while (out.ours.file() >= 0 || err.ours.file() >= 0) {
        pollfd waits[3] = {{in.ours.file(), POLLOUT, 0}, {out.ours.file(), POLLIN, 0}, {err.ours.file(), POLLIN, 0}};
        const int left = millisecondsUntil(deadline), wait = request.stop.stop_possible() ? std::min(left, kStopLookMs) : left;
        if (left == 0 || request.stop.stop_requested()) {
            result.end = ProcessEnd::TimedOut;
            return;
        }
        if (::poll(waits, 3, wait) < 0 && errno != EINTR) return;
        if (waits[0].revents != 0 && !feed(in.ours, rest)) in.ours.close();
        if (waits[1].revents != 0 && !drain(out.ours, result.output, request.outputBytes, request.received, tooMuch)) out.ours.close();
        if (tooMuch) {
            result.end = ProcessEnd::TooMuchOutput;
            return;
        }
        if (waits[2].revents != 0 && !drain(err.ours, result.errors, request.errorBytes, request.received, ignored)) err.ours.close();
    }
}

/// Waits for a child whose outputs are closed; it usually ends at once, but it may linger.
bool waitUntil(pid_t child, Clock::time_point deadline, int& status) {
    for (auto pause = std::chrono::microseconds(50);; pause = std::min(pause * 2, std::chrono::microseconds(20'000))) {
        const pid_t got = ::waitpid(child, &status, WNOHANG);
        if (got == child || (got < 0 && errno != EINTR)) return true;
        if (Clock::now() >= deadline) return false;
        std::this_thread::sleep_for(pause);
    }
}

void killGroup(pid_t child) {
    ::kill(child, SIGKILL); // in case it has not called setpgid yet
    ::kill(-child, SIGKILL);
}

void finish(pid_t child, Clock::time_point deadline, ProcessResult& result) {
    int status = 0;
    if (result.end == ProcessEnd::Exited && !waitUntil(child, deadline, status)) result.end = ProcessEnd::TimedOut;
    if (result.end != ProcessEnd::Exited) {
        killGroup(child);
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
        return;
    }
    if (WIFSIGNALED(status)) {
        result.end = ProcessEnd::Signalled;
        result.signal = WTERMSIG(status);
    } else {
        result.exitCode = WEXITSTATUS(status);
    }
}

Error notStarted(const ProcessRequest& request, int why) {
    return Error{Code::SystemRefused, "cannot run " + request.program + ": " + std::strerror(why)};
}

/// 0, or the errno of the child that could not execute its program.
int reportFrom(const Descriptor& from) {
    int fault = 0;
    ssize_t got = 0;
    while ((got = ::read(from.file(), &fault, sizeof fault)) < 0 && errno == EINTR) {}
    return got == static_cast<ssize_t>(sizeof fault) ? fault : 0;
}

} // namespace

Result<ProcessResult> runProcess(const ProcessRequest& request) {
    const Clock::time_point start = Clock::now();
    const double seconds = std::isfinite(request.seconds) ? std::clamp(request.seconds, 0.0, 86400.0) : 86400.0;
    const auto deadline = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(seconds));

    Channel in, out, err, report;
    if (!openInput(in, !request.input.empty()) || !openPipe(out) || !openPipe(err)) return notStarted(request, errno);
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) return notStarted(request, errno);
    report.ours = Descriptor(ends[0]);
    report.childs = Descriptor(ends[1]);
    for (Channel* channel : {&in, &out, &err, &report})
        if (!liftAboveStandard(*channel)) return notStarted(request, errno);

    std::vector<char*> arguments{const_cast<char*>(request.program.c_str())};
    for (const std::string& argument : request.arguments) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    const ChildPlan plan{request.program.c_str(), arguments.data(),  request.folder.empty() ? nullptr : request.folder.c_str(),
                         request.limits,          ::getpid(),        in.childs.file(),
                         out.childs.file(),       err.childs.file(), report.childs.file()};

    const pid_t child = ::fork();
    if (child < 0) return notStarted(request, errno);
    if (child == 0) becomeChild(plan);
    for (Channel* channel : {&in, &out, &err, &report}) channel->childs.close();

    ProcessResult result;
    if (const int fault = reportFrom(report.ours); fault != 0) {
        int status = 0;
        while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
        return notStarted(request, fault);
    }
    transfer(request, in, out, err, deadline, result);
    finish(child, deadline, result);
    result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return result;
}

std::string describeEnd(const ProcessRequest& request, const ProcessResult& result) {
    switch (result.end) {
    case ProcessEnd::Exited: return "exited with code " + std::to_string(result.exitCode);
    case ProcessEnd::Signalled:
        return "killed by signal " + std::to_string(result.signal) + " (" + ::strsignal(result.signal) + ")";
    case ProcessEnd::TooMuchOutput: return "wrote more than " + std::to_string(request.outputBytes >> 20) + " MiB";
    case ProcessEnd::TimedOut: break;
    }
    std::string text = std::to_string(request.seconds);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return "took longer than " + text + " s";
}

} // namespace trundle
