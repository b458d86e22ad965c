#pragma once
// Work that is done when something first asks for its result.

#include <atomic>
#include <mutex>

namespace trundle {

/// Several threads may ask at the same time, and one of them does the work; it becomes due again while none asks.
class OnDemand {
public:
    explicit OnDemand(bool due = true) : m_done(!due) {}

    void markDue() { m_done.store(false, std::memory_order_relaxed); }
    /// Does the work if it is due. It must not throw, nor ask for itself.
    template <class Work> void ensure(Work&& work) {
        if (m_done.load(std::memory_order_acquire)) return;
        const std::lock_guard lock(m_mutex);
        if (m_done.load(std::memory_order_relaxed)) return;
        work();
        m_done.store(true, std::memory_order_release);
    }

private:
    std::atomic<bool> m_done;
    std::mutex m_mutex;
};

} // namespace trundle
