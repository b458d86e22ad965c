#pragma once
#include <csignal>
#include <cstdint>

namespace trundle {

struct MachineRegisters {
    std::uintptr_t instruction = 0, stack = 0;
};

/// Of a thread that a signal has interrupted; `context` is the argument of a SA_SIGINFO handler. 0 on unknown processors.
inline MachineRegisters registersOf(const void* context) noexcept {
    const auto& machine = static_cast<const ucontext_t*>(context)->uc_mcontext;
#if defined(__x86_64__)
    return {static_cast<std::uintptr_t>(machine.gregs[REG_RIP]), static_cast<std::uintptr_t>(machine.gregs[REG_RSP])};
#elif defined(__aarch64__)
    return {static_cast<std::uintptr_t>(machine.pc), static_cast<std::uintptr_t>(machine.sp)};
#else
    return {};
#endif
}

} // namespace trundle
