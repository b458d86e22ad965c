#pragma once
// Threads that do one piece of work after another together.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <memory>
#include <thread>
#include <type_traits>
#include <vector>

#include "base/platform/wait_word.h"

namespace trundle {

class CallMonitor;

/// Between two runs its threads wait for a moment without sleeping, since the next one is usually near. Where a thread has not begun, as the
/// machine has other work, the calling thread does its piece: on a busy machine a team is as fast as one thread. Used by one thread at a
/// time.
class WorkTeam {
public:
    /// `workers`: with the thread that calls run(). Where the system gives fewer threads it is smaller.
    explicit WorkTeam(unsigned workers);
    WorkTeam(const WorkTeam&) = delete;
    WorkTeam& operator=(const WorkTeam&) = delete;
    ~WorkTeam();

    [[nodiscard]] unsigned size() const { return static_cast<unsigned>(m_threads.size()) + 1; }

    /// Calls work(worker) once for each of the first `workers` of the team, at the same time where their threads are free, and returns when
    /// all have returned. 0 is for the calling thread. `work` must not throw, nor wait for the call of another worker.
    template <class Work> void run(unsigned workers, Work&& work) {
        runAll(
            workers, [](void* w, unsigned worker) { (*static_cast<std::remove_reference_t<Work>*>(w))(worker); }, &work);
    }
    /// Calls part(worker, begin, end) for contiguous parts of [0, count), one for each worker, with at least `least` elements where
    /// there are several. The parts of a count are always the same, so what a worker wrote last is in its own cache.
    template <class Part> void split(std::size_t count, std::size_t least, Part&& part) {
        const std::size_t workers = std::clamp<std::size_t>(count / least, 1, size());
        if (workers == 1) {
            if (count > 0) part(0u, std::size_t{0}, count);
            return;
        }
        run(static_cast<unsigned>(workers),
            [&](unsigned worker) { part(worker, count * worker / workers, count * (worker + 1) / workers); });
    }

private:
    using Function = void (*)(void* work, unsigned worker);
    struct alignas(64) Post { ///< of one thread; padded, so that threads that poll do not disturb each other
        WaitWord round{0};
        std::atomic<std::uint32_t> taken{0}; ///< the last round that somebody does or has done
        std::atomic<bool> sleeps{false};

        /// Whether the caller is to do its piece of the round; false: somebody does it, or has done it.
        [[nodiscard]] bool take(std::uint32_t current) {
            std::uint32_t before = current - 1;
            return taken.compare_exchange_strong(before, current);
        }
    };
    void runAll(unsigned workers, Function function, void* work);
    void serve(Post& post, unsigned worker);

    std::vector<std::unique_ptr<Post>> m_posts;
    std::vector<std::thread> m_threads;
    Function m_function = nullptr;
    void* m_work = nullptr;
    const CallMonitor* m_run = nullptr; ///< of the thread that calls run(): a crash of a thread is one of that run
    std::atomic<unsigned> m_busy{0};
    bool m_ended = false; ///< written before a round begins
};

} // namespace trundle
