#pragma once
#include <memory>
#include <string>

#include "base/call_monitor.h"

namespace trundle {

struct GuardOptions {
    std::shared_ptr<CallMonitor> calls;       ///< state of the run's calls
    const char* activity = "run";             ///< "run", "description", "picture": the activity named in messages
    bool simulates = true;                    ///< there is a simulated time
    bool json = false;                        ///< print the --json object even if the run ends abnormally
};

/// Reports every abnormal end caused by module code during its lifetime: a crash, an exit() of the whole process, or a call that
/// does not return after SIGINT, SIGTERM or SIGHUP. Logs are then flushed, a message names robot and controller, --json prints
/// its object, and the exit code is that of early_end.h. Output of modules to standard output is redirected to standard error. At
/// most one instance, on the run's thread.
class RunGuard {
public:
    explicit RunGuard(GuardOptions options);
    ~RunGuard();
    RunGuard(const RunGuard&) = delete;
    RunGuard& operator=(const RunGuard&) = delete;

    /// Sets the entries of "diagnostics", without brackets, for the --json object after an abnormal end.
    void setDiagnostics(std::string entries);
    /// Sets the members of "robots" at a simulated time, without braces, for the same object.
    void setRobots(std::string members, double timeS);
    /// Sets the complete --json object, without its closing brace, after the last tick. From then on only a single call that does
    /// not return is a timeout.
    void setResults(std::string object);
    /// Call after the results were printed on standard output, to avoid printing them twice.
    void resultsPrinted();
    /// Call when no more ticks follow: a request then ends the program at once.
    void endOnRequest();
    /// Restores standard descriptors, signal handlers and locale that modules may have changed. Cheap enough to call once a
    /// second.
    void restoreProcess();
};

/// True after the first SIGINT, SIGTERM or SIGHUP, or another signal that would end the program: the run must then end normally. A
/// second signal, or a call that does not return, ends the program at once.
[[nodiscard]] bool interrupted();
/// The name of the first signal if it is another one, such as SIGUSR1; else "".
[[nodiscard]] std::string unusualRequest();
/// True in a copy of the process that module code created by fork().
[[nodiscard]] bool isForkedCopy();
[[noreturn]] void endForkedCopy();

} // namespace trundle
