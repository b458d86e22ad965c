#include "crash/exit_hook.h"

#include <atomic>
#include <cstdlib>

#include <sys/syscall.h>
#include <unistd.h>

#include "base/platform/next_symbol.h"
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

// The dynamic loader resolves calls in modules and libraries to these definitions. exit() would run the destructors of static
// objects that other threads still use before the hook; _exit and _Exit skip all handlers.
extern "C" {
void exit(int code) noexcept {
    trundle::callExitHook();
    if (void* real = trundle::nextSymbol("exit")) reinterpret_cast<void (*)(int)>(real)(code);
    trundle::endProcess(code);
}
void _exit(int code) {
    trundle::callExitHook();
    trundle::endProcess(code);
}
void _Exit(int code) noexcept { _exit(code); }
}
