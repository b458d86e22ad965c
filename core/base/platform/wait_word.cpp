#include "base/platform/wait_word.h"

#include <ctime>

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace trundle {

void waitWhile(const WaitWord& word, std::uint32_t value, int timeoutMs) noexcept {
    const timespec timeout{timeoutMs / 1000, timeoutMs % 1000 * 1'000'000L};
    ::syscall(SYS_futex, &word, FUTEX_WAIT, value, timeoutMs < 0 ? nullptr : &timeout, nullptr, 0);
}

void wakeWaiting(WaitWord& word) noexcept { ::syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0); }

void relaxProcessor() noexcept {
#if defined(__x86_64__)
    __builtin_ia32_pause();
#elif defined(__aarch64__)
    asm volatile("yield");
#endif
}

} // namespace trundle
