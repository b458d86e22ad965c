#include "crash/thread_origin.h"

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <memory>
#include <new>

#include <dlfcn.h>
#include <execinfo.h>
#include <pthread.h>
#include <sched.h>
#include <sys/mman.h>

extern "C" const char __executable_start, etext; // the program's own code, from the linker

namespace trundle {
namespace {

constexpr std::size_t kSignalStack = 64 * 1024; // for the handlers of the programs; resident only once it is used
constexpr int kDepth = 32;

constinit thread_local ThreadOrigin t_origin;

using Routine = void* (*)(void*);
using Create = int (*)(pthread_t*, const pthread_attr_t*, Routine, void*);

/// The definition that would have been called: of a sanitizer, or of the C library.
Create realCreate() {
    static const auto s_real = [] {
        void* real = dlsym(RTLD_DEFAULT, "__interceptor_pthread_create");
        return reinterpret_cast<Create>(real ? real : dlsym(RTLD_NEXT, "pthread_create"));
    }();
    return s_real;
}

class SignalStack {
public:
    SignalStack() {
        stack_t now{};
        if (sigaltstack(nullptr, &now) != 0 || (now.ss_flags & SS_DISABLE) == 0) return; // a sanitizer provided one
        m_memory = mmap(nullptr, kSignalStack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_STACK, -1, 0);
        if (m_memory == MAP_FAILED) return;
        const stack_t ours{m_memory, 0, kSignalStack};
        sigaltstack(&ours, nullptr);
    }
    ~SignalStack() {
        if (m_memory == MAP_FAILED) return;
        stack_t now{};
        sigaltstack(nullptr, &now);
        if (now.ss_sp == m_memory) {
            const stack_t none{nullptr, SS_DISABLE, 0};
            sigaltstack(&none, nullptr);
        }
        munmap(m_memory, kSignalStack);
    }
    SignalStack(const SignalStack&) = delete;
    SignalStack& operator=(const SignalStack&) = delete;

private:
    void* m_memory = MAP_FAILED;
};

bool isOfProgram(std::uintptr_t address) {
    return address >= reinterpret_cast<std::uintptr_t>(&__executable_start) && address < reinterpret_cast<std::uintptr_t>(&etext);
}

void add(ThreadOrigin& origin, std::uintptr_t caller) {
    if (origin.count < origin.callers.size()) origin.callers[origin.count++] = caller;
}

/// `caller`: the return address of the call that starts a thread.
ThreadOrigin originFrom(std::uintptr_t caller) {
    ThreadOrigin origin;
    void* frames[kDepth];
    const int count = backtrace(frames, kDepth);
    bool outside = false; // past the frames of this file
    for (int i = 0; i < count; ++i) {
        const auto frame = reinterpret_cast<std::uintptr_t>(frames[i]);
        outside = outside || frame == caller;
        if (!outside) continue;
        if (isOfProgram(frame)) break;
        add(origin, frame);
    }
    for (std::uint32_t i = 0; i < t_origin.count; ++i) add(origin, t_origin.callers[i]);
    return origin;
}

struct Start {
    Routine routine;
    void* argument;
    ThreadOrigin origin;
};

void* runThread(void* data) {
    Start start = *static_cast<Start*>(data);
    delete static_cast<Start*>(data);
    t_origin = start.origin;
    const SignalStack stack; // also released by pthread_exit(), which unwinds
    return start.routine(start.argument);
}

int startThread(pthread_t* thread, const pthread_attr_t* attributes, Routine routine, void* argument, std::uintptr_t caller) {
    const int before = errno;
    auto start = std::unique_ptr<Start>(new (std::nothrow) Start{routine, argument, originFrom(caller)});
    errno = before;
    if (!start) return EAGAIN;
    const int error = realCreate()(thread, attributes, &runThread, start.get());
    if (error == 0) (void)start.release(); // the thread's
    return error;
}

struct StandardStart {
    int (*routine)(void*);
    void* argument;
};

void* runStandardThread(void* data) {
    const StandardStart start = *static_cast<StandardStart*>(data);
    delete static_cast<StandardStart*>(data);
    return reinterpret_cast<void*>(static_cast<std::intptr_t>(start.routine(start.argument)));
}

using Clone = int (*)(int (*)(void*), void*, int, void*, ...);

struct BareStart {
    int (*routine)(void*);
    void* argument;
};

/// A thread of clone() may share the thread-local variables of the thread that started it, also those of malloc(), or have none. So
/// its data is on pages of its own.
int runBareThread(void* data) {
    const BareStart start = *static_cast<BareStart*>(data);
    munmap(data, sizeof(BareStart));
    const SignalStack stack;
    return start.routine(start.argument);
}

std::uintptr_t addressOf(void* code) { return reinterpret_cast<std::uintptr_t>(code); }

} // namespace

const ThreadOrigin& originOfThread() noexcept { return t_origin; }

void provideSignalStack() {
    static thread_local const SignalStack* const s_stack =
        new SignalStack; // never deleted: exit() may crash after the destructors
    (void)s_stack;
}

} // namespace trundle

extern "C" {

int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*routine)(void*), void* argument) noexcept {
    return trundle::startThread(thread, attributes, routine, argument, trundle::addressOf(__builtin_return_address(0)));
}

/// Of C11 <threads.h>; the C library's own would not call the definition above.
int thrd_create(pthread_t* thread, int (*routine)(void*), void* argument) {
    constexpr int kSuccess = 0, kError = 2, kNoMemory = 3;
    auto start = std::unique_ptr<trundle::StandardStart>(new (std::nothrow) trundle::StandardStart{routine, argument});
    if (!start) return kNoMemory;
    const int error = trundle::startThread(thread, nullptr, &trundle::runStandardThread, start.get(),
                                           trundle::addressOf(__builtin_return_address(0)));
    if (error != 0) return error == ENOMEM ? kNoMemory : kError;
    (void)start.release();
    return kSuccess;
}

int clone(int (*routine)(void*), void* stack, int flags, void* argument, ...) noexcept {
    static const auto s_real = reinterpret_cast<trundle::Clone>(dlsym(RTLD_NEXT, "clone"));
    pid_t *parentId = nullptr, *childId = nullptr;
    void* storage = nullptr;
    va_list more; // as far as the flags announce them
    va_start(more, argument);
    const bool hasChildId = (flags & (CLONE_CHILD_SETTID | CLONE_CHILD_CLEARTID)) != 0;
    const bool hasStorage = hasChildId || (flags & CLONE_SETTLS) != 0;
    if (hasStorage || (flags & (CLONE_PARENT_SETTID | CLONE_PIDFD)) != 0) parentId = va_arg(more, pid_t*);
    if (hasStorage) storage = va_arg(more, void*);
    if (hasChildId) childId = va_arg(more, pid_t*);
    va_end(more);
    if (!routine || (flags & CLONE_THREAD) == 0) return s_real(routine, stack, flags, argument, parentId, storage, childId);
    void* const pages = mmap(nullptr, sizeof(trundle::BareStart), PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (pages == MAP_FAILED) return -1;
    const int thread = s_real(&trundle::runBareThread, stack, flags, new (pages) trundle::BareStart{routine, argument}, parentId,
                              storage, childId);
    if (thread < 0) munmap(pages, sizeof(trundle::BareStart));
    return thread;
}
}
