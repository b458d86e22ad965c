#pragma once
#include "base/call_monitor.h"

namespace trundle {

/// The module whose code a crashed thread was executing: found by its instruction pointer or, if that is in no module (the C
/// library, address 0), by the return addresses on its stack, innermost first. `context` is the argument of the SA_SIGINFO
/// handler. nullptr: no known module. Async-signal-safe.
[[nodiscard]] const CallTarget* libraryOfThread(const CallMonitor& calls, const void* context) noexcept;

} // namespace trundle
