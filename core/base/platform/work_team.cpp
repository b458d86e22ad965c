#include "base/platform/work_team.h"

#include <csignal>
#include <system_error>

#include "base/platform/recent_runs.h"

namespace trundle {

namespace {

constexpr int kPolls = 4000; // some 100 microseconds
constexpr int kPollsOfCaller = 20000;

/// Signals for the process go to other threads; those of faults of a thread cannot be blocked usefully.
class BlockedSignals {
public:
    BlockedSignals() {
        sigset_t all;
        sigfillset(&all);
        for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS}) sigdelset(&all, fault);
        pthread_sigmask(SIG_BLOCK, &all, &m_before);
    }
    ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &m_before, nullptr); }

private:
    sigset_t m_before;
};

} // namespace

WorkTeam::WorkTeam(unsigned workers) {
    const BlockedSignals inherited;
    for (unsigned i = 1; i < workers; ++i) {
        m_posts.push_back(std::make_unique<Post>());
        try {
            m_threads.emplace_back([this, i, post = m_posts.back().get()] { serve(*post, i); });
        } catch (const std::system_error&) {
            m_posts.pop_back();
            break;
        }
    }
}

WorkTeam::~WorkTeam() {
    m_ended = true;
    for (const auto& post : m_posts) {
        post->round.fetch_add(1);
        wakeWaiting(post->round);
    }
    for (std::thread& thread : m_threads) thread.join();
}

void WorkTeam::runAll(unsigned workers, Function function, void* work) {
    const unsigned others = std::min(workers, size()) - 1;
    m_function = function;
    m_work = work;
    m_run = runOfThread();
    m_busy.store(others, std::memory_order_relaxed);
    for (unsigned i = 0; i < others; ++i) {
        Post& post = *m_posts[i];
        post.round.fetch_add(1);
        if (post.sleeps.exchange(false)) wakeWaiting(post.round);
    }
    function(work, 0);
    for (unsigned i = 0; i < others; ++i) {
        if (!m_posts[i]->take(m_posts[i]->round.load(std::memory_order_relaxed))) continue;
        function(work, i + 1);
        m_busy.fetch_sub(1, std::memory_order_relaxed);
    }
    for (int polls = 0; m_busy.load(std::memory_order_acquire) > 0; ++polls) {
        if (polls < kPollsOfCaller) relaxProcessor();
        else std::this_thread::yield();
    }
}

void WorkTeam::serve(Post& post, unsigned worker) {
    for (std::uint32_t last = 0;;) {
        std::uint32_t round;
        for (int polls = 0; (round = post.round.load()) == last; ++polls) {
            if (polls < kPolls) {
                relaxProcessor();
                continue;
            }
            post.sleeps.store(true); // whoever begins a round after this wakes it, and a round before this ends the wait at once
            waitWhile(post.round, last, -1);
            post.sleeps.store(false);
        }
        last = round;
        if (!post.take(round)) continue;
        if (m_ended) return;
        setRunOfThread(m_run);
        m_function(m_work, worker);
        setRunOfThread(nullptr);
        m_busy.fetch_sub(1, std::memory_order_release);
    }
}

} // namespace trundle
