#include "crash/crash_site.h"

#include <link.h>
#include <sys/uio.h>
#include <unistd.h>

#include "crash/machine_registers.h"
#include "crash/thread_origin.h"

namespace trundle {
namespace {

constexpr std::uintptr_t kPage = 4096, kMaxStack = 256 * 1024;

/// The first word on a stack that is an address in a module.
const CallTarget* libraryOnStack(const CallMonitor& calls, std::uintptr_t stack) noexcept {
    std::uintptr_t words[kPage / sizeof(std::uintptr_t)];
    // The kernel copies the stack and reports its end; reading it directly could crash again.
    for (std::uintptr_t at = stack & ~(sizeof(std::uintptr_t) - 1); at - stack < kMaxStack || at < stack;) {
        const std::uintptr_t bytes = kPage - at % kPage;
        const iovec here{words, bytes}, there{reinterpret_cast<void*>(at), bytes};
        const ssize_t copied = process_vm_readv(getpid(), &here, 1, &there, 1, 0);
        if (copied <= 0) return nullptr;
        for (std::size_t i = 0; i < static_cast<std::size_t>(copied) / sizeof(std::uintptr_t); ++i)
            if (const CallTarget* library = calls.libraryAt(words[i])) return library;
        at += bytes;
    }
    return nullptr;
}

const CallTarget* libraryOfOrigin(const CallMonitor& calls) noexcept {
    const ThreadOrigin& origin = originOfThread();
    for (std::uint32_t i = 0; i < origin.count; ++i)
        if (const CallTarget* library = calls.libraryAt(origin.callers[i])) return library;
    return nullptr;
}

} // namespace

const CallTarget* libraryOfThread(const CallMonitor& calls, const void* context) noexcept {
    const MachineRegisters registers = registersOf(context);
    if (const CallTarget* library = calls.libraryAt(registers.instruction)) return library;
    if (const CallTarget* library = libraryOnStack(calls, registers.stack)) return library;
    return libraryOfOrigin(calls);
}

const CallTarget* libraryOfCaller(const CallMonitor& calls) noexcept {
    const CallTarget* library = libraryOnStack(calls, reinterpret_cast<std::uintptr_t>(__builtin_frame_address(0)));
    return library ? library : libraryOfOrigin(calls);
}

bool hasLoadedModules(const CallMonitor& calls) noexcept {
    const auto isModule = [](dl_phdr_info* library, std::size_t, void* monitor) {
        for (int i = 0; i < library->dlpi_phnum; ++i) {
            const ElfW(Phdr)& part = library->dlpi_phdr[i];
            const bool isCode = part.p_type == PT_LOAD && (part.p_flags & PF_X);
            if (isCode && static_cast<const CallMonitor*>(monitor)->libraryAt(library->dlpi_addr + part.p_vaddr)) return 1;
        }
        return 0;
    };
    return dl_iterate_phdr(isModule, const_cast<CallMonitor*>(&calls)) != 0;
}

} // namespace trundle
