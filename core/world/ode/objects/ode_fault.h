#pragma once
// ODE ends the process when an assertion fails. Its three handlers are replaced once per process; the replacements throw, and
// every entry point of this folder catches. ODE's space callbacks must not be called from here: a throw would leave a space
// locked.

#include <cstdint>

namespace trundle {

/// Thrown where ODE would have ended the process. ODE's message refers to its source code and does not help users, so it is
/// dropped.
struct OdeFault {};

/// Initialises ODE and replaces its handlers; may be called repeatedly, from any thread.
void startOde();
/// Allocates the collision buffers that ODE keeps per thread for the calling thread.
void prepareThread();
/// Leaks an ODE object that a fault left inconsistent: destroying it would end the process.
void abandon(void* threading);
/// Number of messages ODE has issued on this thread ("LCP internal error"); each means a singular system.
[[nodiscard]] std::uint64_t odeMessages();
/// Counts messages of other threads, which worked for this one.
void addOdeMessages(std::uint64_t count);

} // namespace trundle
