#pragma once
#include <memory>
#include <string>

#include "base/call_monitor.h"

namespace trundle {

struct GuardOptions {
    std::shared_ptr<const CallMonitor> calls; ///< what the run tells of itself
    const char* activity = "run";             ///< "run", "description", "picture": what a module may interrupt
    bool simulates = true;                    ///< there is a simulated time
    bool json = false;                        ///< print the object of --json whatever happens
};

/// While it lives, nothing that code of a module does ends the program without a word: a crash, an exit() of the whole process, a call
/// that does not return after SIGINT, SIGTERM or SIGHUP. The logs are then written out, a sentence names robot and controller, --json
/// prints its object, and the exit code is that of early_end.h. What modules print to standard output goes to standard error. One at a
/// time, on the thread that runs.
class RunGuard {
public:
    explicit RunGuard(GuardOptions options);
    ~RunGuard();
    RunGuard(const RunGuard&) = delete;
    RunGuard& operator=(const RunGuard&) = delete;

    /// Entries of "diagnostics", without brackets, for the object of --json in the middle of the run.
    void setDiagnostics(std::string entries);
    /// Members of "robots" at a simulated time, without braces, for the same object.
    void setRobots(std::string members, double timeS);
    /// The ticks are over and this is the object of --json, without its end. Calls that go on one after the other are waited for now.
    void setResults(std::string object);
    /// They are on standard output: nothing more goes there.
    void resultsPrinted();
    /// No more ticks follow whose end could be waited for: a request ends the program at once.
    void endOnRequest();
    /// Undoes what modules did to the standard descriptors, the signals and the locale. Cheap enough for once a second.
    void restoreProcess();
};

/// The first SIGINT, SIGTERM or SIGHUP came: the run is to end in good order. A second one ends it at once, and so does a call that does
/// not return.
[[nodiscard]] bool interrupted();
/// This is a copy of the run that code of a module made by fork().
[[nodiscard]] bool isForkedCopy();
[[noreturn]] void endForkedCopy();
/// Past all guards, without a word. Async-signal-safe.
[[noreturn]] void endProcess(int code);

} // namespace trundle
