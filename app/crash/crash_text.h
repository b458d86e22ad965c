#pragma once
// What is said of a crash, or of an exit() that is not the program's. Everything here is async-signal-safe.

#include <csignal>

#include "base/call_monitor.h"
#include "base/platform/crash_name.h"
#include "crash/signal_text.h"

namespace trundle {

/// The run that a crash ends.
struct CrashedRun {
    const CallMonitor* calls = nullptr;
    const char* activity = "run"; ///< what is interrupted: "run", "description"
    bool simulates = true;        ///< there is a simulated time
};

struct CrashCause {
    int signal = 0;                       ///< 0: an exit()
    bool onRunsThread = true;             ///< false: a thread started by module code, or a worker thread of the program
    const CallTarget* threadOf = nullptr; ///< in another thread: the module it executes; nullptr: unknown
};

/// Writes a message in parts, either to the terminal or into a JSON string.
class MessageBuilder {
public:
    MessageBuilder(SignalText& out, bool json) : m_out(out), m_json(json) {}
    MessageBuilder& operator<<(const char* text) {
        m_out.addClean(text, m_json);
        return *this;
    }
    MessageBuilder& operator<<(double number) {
        m_out.add(number);
        return *this;
    }

private:
    SignalText& m_out;
    bool m_json;
};

/// The module code that the run's thread is calling; nullptr while the solver or nothing of a module runs.
[[nodiscard]] const CallTarget* moduleCall(const CallMonitor* calls);
[[nodiscard]] bool isInSolver(const CallMonitor* calls);
/// The module call at fault; a crash in another thread is not caused by the run thread's call.
[[nodiscard]] const CallTarget* crashSite(const CrashedRun& run, const CrashCause& cause);

/// "the controller LinearMotion of robot0 (/x/liblinear.so)".
void addTarget(MessageBuilder& words, const CallTarget& target);
/// " in update", " while it was loaded and described".
void addPhase(MessageBuilder& words, const CallMonitor& calls);
/// " at t = 0.49 s".
void addTime(MessageBuilder& words, const CrashedRun& run);
/// "the controller ... crashed in update at t = 0.49 s: Segmentation fault".
void addCrash(MessageBuilder& words, const CrashedRun& run, const CrashCause& cause);
/// "the controller ... ended the program in update at t = 0.49 s, by exit() or the like".
void addExit(MessageBuilder& words, const CrashedRun& run, const CrashCause& cause);
/// The signals of a crash.
inline constexpr int kCrashSignals[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS};

} // namespace trundle
