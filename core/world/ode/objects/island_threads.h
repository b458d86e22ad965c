#pragma once
// ODE's interface to threads for a WorkTeam: islands are stepped side by side.
//
// Method: ODE posts one call for each thread, which goes on to take island after island. All that is posted from within such a call
// stays on its thread, so only the call that waits for all of them is shared. The result of an island depends on the island alone,
// so no bit depends on the number of threads.

#include <atomic>
#include <deque>
#include <memory>
#include <thread>
#include <vector>

#include <ode/ode.h>

#include "base/platform/work_team.h"

namespace trundle {

class IslandThreads {
public:
    /// The team outlives it.
    explicit IslandThreads(WorkTeam& team);
    /// The world uses it until it is destroyed or has another.
    void giveTo(dWorldID world);
    /// Whether the next steps are shared by all threads. ODE has memory for all of them in either case: to ask it for fewer threads would
    /// return and take that again.
    void share(bool shared) { m_shared = shared; }

private:
    struct Wait {
        bool isOver = false;
    };
    struct Call {
        dThreadedCallFunction* run = nullptr;
        void* context = nullptr;
        dcallindex_t index = 0;
        Call* next = nullptr; ///< waits for this one
        Wait* wait = nullptr;
        int* fault = nullptr;                ///< where a fault is reported
        bool isOwn = false;                  ///< posted from outside of any call
        bool hasRun = false;                 ///< or runs
        std::atomic<std::ptrdiff_t> open{0}; ///< that it waits for
        std::atomic<bool> failed{false};
    };
    struct alignas(64) Worker {
        std::vector<Call*> ready, unused;
        std::deque<Call> calls;
    };
    struct Functions; ///< of ODE's table

    [[nodiscard]] static Call* take(Worker& worker);
    void post(int* fault, dCallReleaseeID* posted, std::ptrdiff_t open, Call* next, Wait* wait, dThreadedCallFunction* run,
              void* context, dcallindex_t index);
    void release(Worker& worker, Call& call, std::ptrdiff_t count);
    /// The first calls from `worker` on, each `every`-th of them, and all that follows from them.
    void work(unsigned worker, std::size_t every);
    void workOff();

    WorkTeam& m_team;
    std::vector<std::unique_ptr<Worker>> m_workers;
    std::vector<Call*> m_own;   ///< posted from outside of any call
    std::vector<Call*> m_first; ///< of these those that are ready, one for each thread
    bool m_shared = true;
    std::atomic<bool> m_faulted{false};
    std::atomic<unsigned> m_arrivals{
        0}; ///< and departures: who comes sees what those who have gone did, whose memory it may get from ODE
    std::atomic<std::uint64_t> m_messages{0}; ///< of ODE on other threads
    std::thread::id m_caller;                 ///< of workOff()

    static thread_local Worker* t_worker; ///< whose call this thread is in
};

} // namespace trundle
