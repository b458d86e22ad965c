#pragma once
#include <atomic>
#include <cstdint>

namespace trundle {

/// A number in shared memory on which one process waits until another changes it (a futex).
using WaitWord = std::atomic<std::uint32_t>;
static_assert(WaitWord::is_always_lock_free);

/// Returns when the word has another value than `value`, after the timeout, or spuriously. timeoutMs < 0: no timeout.
void waitWhile(const WaitWord& word, std::uint32_t value, int timeoutMs) noexcept;
void wakeWaiting(WaitWord& word) noexcept;
/// A hint to the processor, for loops that poll a word.
void relaxProcessor() noexcept;

} // namespace trundle
