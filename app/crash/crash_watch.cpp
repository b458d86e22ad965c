// Needs: handlers of signals and of exit(), which take no arguments of ours, hence the global variables below.
// Method: the first thread that ends the program reports and ends it; others wait.
#include "crash/crash_watch.h"

#include <atomic>
#include <csignal>
#include <cstring>

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "base/platform/output_cleaner.h"
#include "base/platform/recent_runs.h"
#include "crash/crash_site.h"
#include "crash/crash_text.h"
#include "crash/exit_hook.h"
#include "crash/last_steps.h"
#include "crash/thread_origin.h"
#include "crash/uncaught_exception.h"

namespace trundle {
namespace {

const char *s_program = "", *s_advice = "";
std::atomic<const char*> s_reportFile{nullptr};
std::atomic<pid_t> s_process{0};
std::atomic<long> s_endingThread{0};

/// What ends the process, as far as it is known: a run without a cause in it is not the fault of a module.
struct Found {
    CrashedRun run;
    CrashCause cause;

    [[nodiscard]] bool isOfModule() const { return crashSite(run, cause) || cause.threadOf; }
};

/// `find` returns the module of a run whose code the thread executes.
template <class Find> Found found(int signal, Find find) {
    if (const CallMonitor* run = runOfThread()) return {{run}, {signal}};
    for (const CallMonitor* run : recentRuns())
        if (const CallTarget* library = run ? find(*run) : nullptr) return {{run}, {signal, false, library}};
    return {{}, {signal, false}};
}

void setHandler(int signal, void (*handler)(int, siginfo_t*, void*)) {
    struct sigaction action = {};
    action.sa_flags = SA_ONSTACK | SA_NODEFER;
    if (handler) {
        action.sa_flags |= SA_SIGINFO;
        action.sa_sigaction = handler;
    } else {
        action.sa_handler = SIG_DFL;
    }
    sigemptyset(&action.sa_mask);
    sigaction(signal, &action, nullptr);
}

/// Ends the thread's process as without a handler, with a core file where those are enabled.
void raiseDefault(int signal) {
    setHandler(signal, nullptr);
    sigset_t only;
    sigemptyset(&only);
    sigaddset(&only, signal);
    pthread_sigmask(SIG_UNBLOCK, &only, nullptr);
    syscall(SYS_tgkill, getpid(), syscall(SYS_gettid), signal);
}

/// True for the first fault of the one thread that may end the process; it returns to no other thread.
bool enter() {
    const long self = syscall(SYS_gettid);
    long ending = 0;
    if (s_endingThread.compare_exchange_strong(ending, self)) return true;
    while (ending != self) pause();
    return false;
}

/// Where a thread reports an exception that ends the program. It does not return while another one ends it.
int messages() {
    const long ending = s_endingThread;
    if (ending != 0 && ending != syscall(SYS_gettid)) (void)enter();
    return STDERR_FILENO;
}

void addCause(MessageBuilder& words, const Found& what) {
    if (what.cause.signal == 0 && !what.isOfModule()) words << "ended from within, by code of a module or as the display is gone";
    else if (what.cause.signal == 0) addExit(words, what.run, what.cause);
    else if (what.run.calls) addCrash(words, what.run, what.cause);
    else
        words << "crashed: " << crashName(what.cause.signal)
              << "; the fault is the program's own, or damage that code of a module did before";
}

void addMessage(int to, const Found& what) {
    SignalText out(to);
    MessageBuilder words(out, false);
    words << s_program << ": ";
    addCause(words, what);
    words << "; " << s_advice;
    out.add("\n");
}

void addReport(int to, const Found& what) {
    SignalText out(to);
    MessageBuilder words(out, false);
    addCause(words, what);
    if (*uncaughtException()) words << "; uncaught exception: " << uncaughtException();
    out.add("\n");
}

class WatchSteps final : public LastSteps {
public:
    Found what;
    bool ofModule = false;

    void report() override {
        ofModule = what.isOfModule();
        Draft message(STDERR_FILENO);
        addMessage(message.file(), what);
        message.publish();
        m_said = true;
        writeFile();
    }
    void reportWithoutHeap() override {
        what.run.calls = nullptr;
        what.cause.threadOf = nullptr;
        if (!m_said) addMessage(STDERR_FILENO, what);
        writeFile();
    }
    void reportLostLogs() override {
        SignalText(STDERR_FILENO).add(s_program).add(": logs may end early, their memory is damaged too\n");
    }

private:
    void writeFile() const {
        const char* path = s_reportFile;
        const int file = path ? open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600) : -1;
        if (file < 0) return;
        Draft report(file);
        addReport(report.file(), what);
        report.publish();
    }

    bool m_said = false;
} s_last;

void onCrash(int signal, siginfo_t*, void* context) {
    if (getpid() != s_process) return raiseDefault(signal);
    if (enter()) {
        s_last.what = {{}, {signal, false}};
        s_last.what = found(signal, [context](const CallMonitor& run) { return libraryOfThread(run, context); });
    }
    s_last.take();
    if (s_last.ofModule) endProcess(kExitOfModuleFault);
    finishOutputCleaner();
    raiseDefault(s_last.what.cause.signal);
}

/// Ends immediately, since static destructors would destroy objects that other threads still use.
void onExit() {
    if (getpid() != s_process) return;
    if (enter()) s_last.what = found(0, [](const CallMonitor& run) { return libraryOfCaller(run); });
    s_last.take();
    endProcess(kExitOfModuleFault);
}

} // namespace

void watchCrashes(const char* program, const char* advice) {
    s_program = program;
    s_advice = advice;
    s_process = getpid();
    provideSignalStack();
    reportUncaughtExceptions(program, &messages);
    // Does not replace existing handlers, such as those of a debugger or a sanitizer.
    for (const int signal : kCrashSignals) {
        struct sigaction now = {};
        if (sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_DFL) setHandler(signal, &onCrash);
    }
}

void keepCrashReport(const char* file) { s_reportFile = strdup(file); }

void watchExits() { setExitHook(&onExit); }

void ignoreExits() { setExitHook(nullptr); }

} // namespace trundle
