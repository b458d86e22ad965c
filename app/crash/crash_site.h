#pragma once
#include "base/call_monitor.h"

namespace trundle {

/// The module at fault in a thread that is not the run's: found by the thread's instruction pointer or, if that is in no module
/// (the C library, address 0), by the return addresses on its stack, innermost first, else by the code that started the thread.
/// `context` is the argument of a SA_SIGINFO handler. nullptr: no known module. Async-signal-safe.
[[nodiscard]] const CallTarget* libraryOfThread(const CallMonitor& calls, const void* context) noexcept;
/// The same for the code that is calling.
[[nodiscard]] const CallTarget* libraryOfCaller(const CallMonitor& calls) noexcept;

/// Whether the process has a library that the monitor knows. Not async-signal-safe.
[[nodiscard]] bool hasLoadedModules(const CallMonitor& calls) noexcept;

} // namespace trundle
