#include "world/ode/objects/ode_fault.h"

#include <cstdarg>
#include <mutex>
#include <vector>

#include <ode/ode.h>

#include "world/ode/lcp/solve_lcp.h"

namespace trundle {

namespace {

thread_local std::uint64_t t_messages = 0;

[[noreturn]] void onFault(int, const char*, va_list) { throw OdeFault{}; }
void onMessage(int, const char*, va_list) { ++t_messages; }

} // namespace

void startOde() {
    static std::once_flag once;
    std::call_once(once, [] {
        (void)solvedIslands();
        dInitODE2(0);
        dSetErrorHandler(onFault);
        dSetDebugHandler(onFault);
        dSetMessageHandler(onMessage);
    });
}

void prepareThread() {
    thread_local const bool ready = dAllocateODEDataForThread(dAllocateMaskAll) != 0;
    (void)ready;
}

void abandon(void* threading) {
    static std::mutex lock;
    static auto* const abandoned = new std::vector<void*>; // stays reachable, so that leak checkers do not report it
    const std::scoped_lock guard(lock);
    abandoned->push_back(threading);
}

std::uint64_t odeMessages() { return t_messages; }

void addOdeMessages(std::uint64_t count) { t_messages += count; }

} // namespace trundle
