// Needs: handlers of signals and of exit(), which take no arguments of ours, hence the global variables below.
// Assumes: one guard at a time; the thread that creates it is the run's thread.
// Method: signal handlers only record requests, a watch thread decides. The first thread that ends the program does so alone.
#include "cli/run_guard.h"

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <optional>
#include <thread>

#include <pthread.h>
#include <semaphore.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/platform/end_requests.h"
#include "base/platform/output_cleaner.h"
#include "cli/early_end.h"
#include "cli/exit_code.h"
#include "cli/standard_streams.h"
#include "crash/crash_site.h"
#include "crash/exit_hook.h"
#include "crash/last_steps.h"
#include "crash/signal_text.h"
#include "crash/thread_origin.h"
#include "crash/uncaught_exception.h"

namespace trundle {

namespace {

constexpr int kRequests[] = {SIGINT, SIGTERM, SIGHUP};
constexpr std::uint32_t kCallTimeoutS = 3;  // s, for one call after a request to end
constexpr std::uint32_t kTickTimeoutS = 10; // s, for all calls of a tick
constexpr long kLookEveryNs = 100'000'000;

std::atomic<bool> s_guarded{false}, s_ticking{false}, s_waiting{true};
std::atomic<int> s_requests{0}, s_firstRequest{0}; // count, and the first signal
std::atomic<long> s_endingThread{0};               // id of the thread that ends the program; 0: none
std::atomic<pid_t> s_process{0};
long s_runsThread = 0;
EarlyEndFacts s_facts;
std::shared_ptr<CallMonitor> s_calls;
KeptText s_diagnostics, s_results;
EarlyPoses s_poses[2]; // double buffer: one may be printed while the other is updated
sem_t s_wake;
std::atomic<bool> s_stop{false};
std::optional<std::thread> s_watch;
bool s_ignoresHangup = false;

long thisThread() { return syscall(SYS_gettid); }

void setHandler(int signal, void (*handler)(int), int flags) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void raiseDefault(int signal) {
    setHandler(signal, SIG_DFL, 0);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    syscall(SYS_tgkill, getpid(), thisThread(), signal);
}

/// If core dumps are enabled, a forked copy of the process produces one; the process itself exits with the documented code.
void dumpCore(int signal) {
    rlimit core{};
    if (getrlimit(RLIMIT_CORE, &core) != 0 || core.rlim_cur == 0) return;
    const long copy = syscall(SYS_clone, SIGCHLD, nullptr, nullptr, nullptr, nullptr);
    if (copy == 0) {
        raiseDefault(signal);
        endProcess(kExitController);
    }
    while (copy > 0 && waitpid(static_cast<pid_t>(copy), nullptr, 0) < 0 && errno == EINTR) {}
}

/// The report is the last line.
class GuardSteps final : public LastSteps {
public:
    EarlyEnd end;
    int code = kExitController;

    void report() override {
        code = exitCodeOf(s_facts, end);
        waitForOutputCleaner();
        reportEarlyEnd(s_facts, end);
    }
    void reportWithoutHeap() override {
        s_facts.calls = nullptr;
        s_facts.simulates = false;
        end.cause.threadOf = nullptr;
        code = exitCodeOf(s_facts, end);
        reportEarlyEnd(s_facts, end);
    }
    void reportLostLogs() override {
        SignalText(messagesFile()).add("trundle-cli: logs may end early, their memory is damaged too\n");
    }
} s_last;

/// Async-signal-safe. Only the first caller reports; a crash in another thread adds nothing.
[[noreturn]] void endEarly(const EarlyEnd& end) {
    const long self = thisThread();
    long ending = 0;
    if (s_endingThread.compare_exchange_strong(ending, self)) s_last.end = end;
    else
        while (ending != self) pause();
    s_last.take();
    if (s_last.end.kind == EarlyEndKind::Crash) {
        finishOutputCleaner();
        if (s_last.code > 128) raiseDefault(s_last.end.cause.signal); // a crash of the program itself ends as without a handler
        dumpCore(s_last.end.cause.signal);
    }
    endProcess(s_last.code);
}

/// After a run, whose results are printed: only code of modules is known to damage memory.
void endAfterRun(int signal) {
    SignalText out(messagesFile());
    out.add("trundle-cli: ended after its results by a damage of memory, which code of a module did most likely: ");
    out.add(crashName(signal)).add("\n");
    out.flush();
    dumpCore(signal);
    endProcess(kExitController);
}

bool isOurs() { return s_guarded && getpid() == s_process; }

void onCrash(int signal, siginfo_t*, void* context) {
    if (!s_guarded && s_facts.hasModules && getpid() == s_process) endAfterRun(signal);
    if (!isOurs()) return raiseDefault(signal);
    EarlyEnd end{EarlyEndKind::Crash, {signal, thisThread() == s_runsThread}};
    if (!end.cause.onRunsThread) end.cause.threadOf = libraryOfThread(*s_calls, context);
    endEarly(end);
}

void handleCrash(int signal) {
    struct sigaction action = {};
    action.sa_sigaction = &onCrash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

void onExit() {
    if (!isOurs()) return;
    EarlyEnd end{EarlyEndKind::Exit, {0, thisThread() == s_runsThread}};
    if (!end.cause.onRunsThread) end.cause.threadOf = libraryOfCaller(*s_calls);
    endEarly(end);
}

void onRequest(int signal) {
    const int before = errno;
    int none = 0;
    s_firstRequest.compare_exchange_strong(none, signal);
    if (s_requests.fetch_add(1) >= 2) endProcess(kExitInterrupted); // two earlier requests had no effect
    sem_post(&s_wake);
    errno = before;
}

void onBrokenPipe(int) {} // makes writes fail with EPIPE; unlike SIG_IGN, a handler is not inherited by child processes

/// Replaces no handler of a module, such as that of its own timer.
void watchOther(int signal) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) setHandler(signal, onRequest, SA_RESTART);
}

void unwatchOther(int signal) {
    struct sigaction now = {};
    if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == onRequest) setHandler(signal, SIG_DFL, 0);
}

void watchSignals() {
    forOtherEndSignals(watchOther);
    watchOther(SIGQUIT);
    for (const int signal : kRequests)
        if (signal != SIGHUP || !s_ignoresHangup) setHandler(signal, onRequest, SA_RESTART);
    setHandler(SIGPIPE, onBrokenPipe, SA_RESTART);
    // Does not replace existing handlers, such as those of a debugger or a sanitizer.
    for (const int signal : kCrashSignals) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) != 0 || (now.sa_handler != SIG_DFL && now.sa_handler != SIG_IGN)) continue;
        handleCrash(signal);
    }
}

void unwatchSignals() {
    forOtherEndSignals(unwatchOther);
    unwatchOther(SIGQUIT);
    for (const int signal : kRequests)
        if (signal != SIGHUP || !s_ignoresHangup) setHandler(signal, SIG_DFL, 0);
    if (s_facts.hasModules) return; // they may have damaged memory
    for (const int signal : kCrashSignals) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) == 0 && (now.sa_flags & SA_SIGINFO) && now.sa_sigaction == &onCrash)
            setHandler(signal, SIG_DFL, 0);
    }
}

/// Module code may have blocked these signals on the run's thread. Other signals, such as a debugger's, stay unchanged.
void unblockSignals() {
    sigset_t ours;
    sigemptyset(&ours);
    for (const int signal : kRequests) sigaddset(&ours, signal);
    for (const int signal : kCrashSignals) sigaddset(&ours, signal);
    pthread_sigmask(SIG_UNBLOCK, &ours, nullptr);
}

double now() {
    timespec t{};
    clock_gettime(CLOCK_MONOTONIC, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void sleepBriefly() {
    timespec until{};
    clock_gettime(CLOCK_REALTIME, &until);
    until.tv_nsec += kLookEveryNs;
    until.tv_sec += until.tv_nsec / 1'000'000'000;
    until.tv_nsec %= 1'000'000'000;
    sem_timedwait(&s_wake, &until);
}

/// Runs on its own thread: ends the program if a request to end has no effect in time.
void watch() {
    double asked = 0, call = 0; // time of the request; start of the current call
    std::uint64_t sequence = 0;
    for (int looks = 0; !s_stop; ++looks) {
        sleepBriefly();
        if (looks % 10 == 0) watchSignals(); // modules may have replaced the handlers
        if (s_requests == 0) continue;
        s_calls->askForEnd();
        if (s_requests > (s_waiting ? 1 : 0)) endEarly({EarlyEndKind::Interrupted});
        const double t = now();
        if (asked == 0) asked = t;
        if (const std::uint64_t current = s_calls->sequence(); call == 0 || current != sequence) {
            sequence = current;
            call = t;
        }
        if (!s_calls->target()) continue;
        const std::uint32_t waited = t - call >= kCallTimeoutS                 ? kCallTimeoutS
                                     : s_ticking && t - asked >= kTickTimeoutS ? kTickTimeoutS
                                                                               : 0;
        if (waited) endEarly({EarlyEndKind::NotResponding, {}, waited});
    }
}

} // namespace

RunGuard::RunGuard(GuardOptions options) {
    s_calls = std::move(options.calls);
    s_facts.calls = s_calls.get();
    s_facts.activity = options.activity;
    s_facts.simulates = options.simulates;
    s_facts.json = options.json;
    s_facts.startS = now();
    s_facts.terminal = isatty(messagesFile()) == 1;
    s_process = getpid();
    s_runsThread = thisThread();
    s_ticking = true;

    redirectStandardOutput();
    static const locale_t s_locale = newlocale(LC_ALL_MASK, "C", nullptr);
    uselocale(s_locale); // for this thread, even if a module changes the process locale
    struct sigaction hangup = {};
    s_ignoresHangup = sigaction(SIGHUP, nullptr, &hangup) == 0 && hangup.sa_handler == SIG_IGN; // nohup
    provideSignalStack();
    setExitHook(&onExit);
    s_guarded = true;
    reportUncaughtExceptions("trundle-cli", &messagesFile);
    watchSignals();
    sem_init(&s_wake, 0, 0);
    s_watch.emplace(&watch);
}

RunGuard::~RunGuard() {
    s_stop = true;
    sem_post(&s_wake);
    s_watch->join();
    s_watch.reset();
    s_guarded = false;
    unwatchSignals();
}

void RunGuard::setDiagnostics(std::string entries) {
    s_facts.diagnostics = nullptr;
    s_diagnostics = KeptText(entries);
    s_facts.diagnostics = &s_diagnostics;
}

void RunGuard::setRobots(std::string members, double timeS) {
    EarlyPoses& next = s_facts.poses.load() == &s_poses[0] ? s_poses[1] : s_poses[0];
    next.members = KeptText(members);
    next.timeS = timeS;
    s_facts.poses = &next;
}

void RunGuard::setResults(std::string object) {
    s_results = KeptText(object);
    s_facts.results = &s_results;
    s_ticking = false;
}

void RunGuard::endOnRequest() { s_waiting = false; }

void RunGuard::resultsPrinted() { s_facts.json = false; }

void RunGuard::restoreProcess() {
    s_facts.hasModules = s_facts.hasModules || hasLoadedModules(*s_calls);
    restoreStandardStreams();
    unblockSignals();
}

bool interrupted() { return s_requests != 0; }

std::string unusualRequest() {
    const int signal = s_firstRequest;
    if (signal == 0 || std::ranges::find(kRequests, signal) != std::end(kRequests)) return {};
    const char* name = sigabbrev_np(signal);
    return name ? std::string("SIG") + name : std::to_string(signal);
}

bool isForkedCopy() { return s_process != 0 && getpid() != s_process; }

void endForkedCopy() {
    SignalText(messagesFile()).add("trundle-cli: a copy of the program that code of a module made by fork() was ended\n");
    endProcess(kExitController);
}

} // namespace trundle
