#pragma once

namespace trundle {

/// For a program with runs in threads of their own (RunOfThread). When code of a module crashes it or calls exit(), flushes all logs,
/// prints one sentence on standard error that names the module, robot and phase, with `advice` at its end, and ends the process
/// with kExitOfModuleFault. A crash that is not of a module is reported as well and then ends as without a handler. Both texts must
/// live as long as the process. Call once, on the main thread.
void watchCrashes(const char* program, const char* advice);

/// The sentence is also written to this file, unless it exists. Call at most once.
void keepCrashReport(const char* file);

inline constexpr int kExitOfModuleFault = 4;

/// Handlers of exit() that are registered later run earlier: call this again when objects were created since.
void watchExits();
/// From here on exit() is the program's own.
void ignoreExits();

} // namespace trundle
