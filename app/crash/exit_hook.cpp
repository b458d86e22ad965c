#include "crash/exit_hook.h"

#include <atomic>
#include <cstdlib>

#include <sys/syscall.h>
#include <unistd.h>

#include "base/platform/output_cleaner.h"

namespace trundle {
namespace {

std::atomic<void (*)()> s_hook{nullptr};

} // namespace

static void callExitHook() {
    if (void (*hook)() = s_hook) hook();
}

void setExitHook(void (*hook)()) {
    s_hook = hook;
    if (!hook) return;
    std::atexit(&callExitHook);
    static const int s_quick = std::at_quick_exit(&callExitHook);
    (void)s_quick;
}

void endProcess(int code) {
    finishOutputCleaner();
    for (;;) syscall(SYS_exit_group, code);
}

} // namespace trundle

// _exit and _Exit skip all handlers: the dynamic loader resolves calls in modules and libraries to these definitions.
extern "C" {
void _exit(int code) {
    trundle::callExitHook();
    trundle::endProcess(code);
}
void _Exit(int code) noexcept { _exit(code); }
}
