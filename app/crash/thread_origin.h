#pragma once
// Threads that code of modules starts. The programs define pthread_create(), thrd_create() and clone(): the dynamic loader resolves
// calls in modules and libraries to these definitions, so each thread has an alternate signal stack and, except one of clone(), knows
// the code that started it.

#include <array>
#include <cstdint>

namespace trundle {

/// The return addresses in libraries of the code that started a thread, innermost first, then those of the code that started the
/// starting thread. Ends at the program's own code, so a thread that the program starts during a call of a module has none.
struct ThreadOrigin {
    std::array<std::uintptr_t, 16> callers{};
    std::uint32_t count = 0;
};

/// Of the calling thread. Async-signal-safe.
[[nodiscard]] const ThreadOrigin& originOfThread() noexcept;

/// Gives the calling thread an alternate signal stack for its lifetime, without which a stack overflow ends the process before any
/// handler runs. Threads of pthread_create() have one.
void provideSignalStack();

} // namespace trundle
