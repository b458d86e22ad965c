// Needs: handlers of signals and of exit(), which take no arguments of ours, hence the global variables below.
// Method: the first thread that ends the process records why; others wait. The stack is unwound by the compiler's library; where
// that finds no code of the module (a jump to nowhere), the first address on the stack that is in the module counts.
#include "host/crash_recorder.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>
#include <vector>

#include <execinfo.h>
#include <sys/syscall.h>
#include <sys/uio.h>
#include <unistd.h>

#include "crash/exit_hook.h"
#include "crash/machine_registers.h"
#include "crash/thread_origin.h"
#include "crash/uncaught_exception.h"

namespace trundle {
namespace {

constexpr std::size_t kMostAddresses = 128, kStackWords = 4096;

ControlPage* s_page = nullptr;
const CallMonitor* s_calls = nullptr;
std::vector<std::pair<std::uintptr_t, std::uintptr_t>> s_code;
std::uintptr_t s_base = 0, s_sensors = 0, s_sensorsEnd = 0;
long s_mainThread = 0;
std::atomic<long> s_endingThread{0};

long thisThread() { return ::syscall(SYS_gettid); }

void addFrame(CrashRecord& record, std::uintptr_t address) {
    const std::optional<std::uint64_t> offset = offsetInModule(address);
    if (offset && record.frameCount < CrashRecord::kMostFrames) record.frames[record.frameCount++] = {0, *offset};
}

void addFromStack(CrashRecord& record, std::uintptr_t stack) {
    static std::array<std::uintptr_t, kStackWords> s_words;
    const iovec here{s_words.data(), sizeof s_words}, there{reinterpret_cast<void*>(stack & ~std::uintptr_t(7)), sizeof s_words};
    const ssize_t copied = ::process_vm_readv(::getpid(), &here, 1, &there, 1, 0);
    for (std::size_t i = 0; copied > 0 && i < static_cast<std::size_t>(copied) / sizeof(std::uintptr_t); ++i)
        if (offsetInModule(s_words[i])) return addFrame(record, s_words[i]);
}

void enter() {
    const long self = thisThread();
    long ending = 0;
    if (s_endingThread.compare_exchange_strong(ending, self)) return;
    if (ending == self) endProcess(1);
    for (;;) ::pause();
}

void addAddresses(CrashRecord& record, std::uintptr_t innermost) {
    if (innermost != 0) addFrame(record, innermost + 1); // the others are return addresses, behind their calls
    static std::array<void*, kMostAddresses> s_addresses;
    const int count = ::backtrace(s_addresses.data(), static_cast<int>(s_addresses.size()));
    for (int i = 0; i < count; ++i)
        if (const auto address = reinterpret_cast<std::uintptr_t>(s_addresses[static_cast<std::size_t>(i)]); address != innermost)
            addFrame(record, address);
}

void onCrash(int signal, siginfo_t* info, void* context) {
    enter();
    CrashRecord& record = s_page->crash;
    const MachineRegisters registers = registersOf(context);
    const auto address = reinterpret_cast<std::uintptr_t>(info->si_addr);
    record.signal = signal;
    record.ofThread = thisThread() != s_mainThread;
    record.ofSensorImage = signal == SIGSEGV && address >= s_sensors && address < s_sensorsEnd;
    std::strncpy(record.exception.data(), uncaughtException(), record.exception.size() - 1);
    record.complete = 1; // before the stack is unwound, which may fail on a damaged one
    addAddresses(record, registers.instruction);
    if (record.frameCount == 0) addFromStack(record, registers.stack);
    endProcess(128 + signal);
}

void onExit() {
    enter();
    CrashRecord& record = s_page->crash;
    record.ofThread = thisThread() != s_mainThread;
    record.complete = 1;
    addAddresses(record, 0);
    endProcess(1);
}

} // namespace

void recordCrashes(ControlPage& page, const CallMonitor& calls) {
    s_page = &page;
    s_calls = &calls;
    s_mainThread = thisThread();
    std::array<void*, 4> none;
    (void)::backtrace(none.data(), static_cast<int>(none.size())); // loads what it needs now
    provideSignalStack();
    reportUncaughtExceptions("trundle-host", [] { return STDERR_FILENO; });
    setExitHook(&onExit);
    for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS, SIGXFSZ}) {
        struct sigaction action = {};
        action.sa_sigaction = &onCrash;
        action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_NODEFER;
        ::sigemptyset(&action.sa_mask);
        ::sigaction(signal, &action, nullptr);
    }
    ::signal(SIGPIPE, [](int) {}); // writes fail with EPIPE, as inside the program
}

void setModuleCode(const DynamicLibrary& library) {
    s_base = library.base();
    s_code = library.code();
    setExitHook(&onExit); // the module may have registered handlers of exit(), which would run earlier
}

std::optional<std::uint64_t> offsetInModule(std::uintptr_t address) {
    const auto isIn = [&](const auto& code) { return address >= code.first && address < code.second; };
    return std::ranges::any_of(s_code, isIn) ? std::optional<std::uint64_t>(address - s_base) : std::nullopt;
}

void setSensorImage(const void* data, std::size_t bytes) {
    s_sensors = reinterpret_cast<std::uintptr_t>(data);
    s_sensorsEnd = s_sensors + bytes;
}

} // namespace trundle
