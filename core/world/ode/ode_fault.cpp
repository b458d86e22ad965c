#include "world/ode/ode_fault.h"

#include <cstdarg>
#include <cstdio>
#include <mutex>
#include <vector>

#include <ode/ode.h>

namespace trundle {

namespace {

thread_local std::uint64_t t_messages = 0;

[[noreturn]] void fault(const char* text, va_list arguments) {
    char buffer[512];
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    throw OdeFault{buffer};
}

void onError(int, const char* text, va_list arguments) { fault(text, arguments); }
void onDebug(int, const char* text, va_list arguments) { fault(text, arguments); }
void onMessage(int, const char*, va_list) { ++t_messages; }

} // namespace

void startOde() {
    static std::once_flag once;
    std::call_once(once, [] {
        dInitODE2(0);
        dSetErrorHandler(onError);
        dSetDebugHandler(onDebug);
        dSetMessageHandler(onMessage);
    });
}

void prepareThread() {
    thread_local const bool ready = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    (void)ready;
}

void abandon(void* threading) {
    static std::mutex lock;
    static auto* const abandoned = new std::vector<void*>; // still known to someone, so that a leak checker sees the intention
    const std::scoped_lock guard(lock);
    abandoned->push_back(threading);
}

std::uint64_t odeMessages() { return t_messages; }

} // namespace trundle
