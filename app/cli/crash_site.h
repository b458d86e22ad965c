#pragma once
#include "base/call_monitor.h"

namespace trundle {

/// Whose code a thread runs that crashed: by its instruction pointer and, where that is in no module (the C library, address 0), by the
/// return addresses on its stack, the innermost first. `context` is what a handler of SA_SIGINFO was given. nullptr: no known module's.
/// Async-signal-safe.
[[nodiscard]] const CallTarget* libraryOfThread(const CallMonitor& calls, const void* context) noexcept;

} // namespace trundle
