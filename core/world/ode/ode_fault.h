#pragma once
// ODE answers a broken promise by ending the process. Its three handlers are installed once for the whole process; ours throw,
// and every entry of this folder catches. Never call ODE's space callbacks from here: a throw would leave a space locked.

#include <cstdint>

namespace trundle {

/// ODE would have ended the process here. Its own words are about its source text and help no user: they are dropped.
struct OdeFault {};

/// Starts ODE and takes over its handlers; any thread, any number of times.
void startOde();
/// Gives the calling thread the collision buffers that ODE keeps per thread.
void prepareThread();
/// Keeps what a fault left half done inside ODE, for good: taking it apart would end the program.
void abandon(void* threading);
/// Messages ODE has given on this thread so far ("LCP internal error"); each means a singular system.
[[nodiscard]] std::uint64_t odeMessages();

} // namespace trundle
