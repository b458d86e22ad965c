#pragma once
// Records which module code a run is executing, so that another thread or a crash handler can report it when the run itself
// cannot.

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/floating_point.h"

namespace trundle {

/// The module code that is called.
struct CallTarget {
    static constexpr std::uint32_t kNoRobot = 0xffffffffu;

    std::string text;   ///< "the controller LinearMotion of robot0", "the device robot0/spinner", "the module libx.so"
    std::string robot;  ///< "robot0"; empty: none
    std::string kind;   ///< "LinearMotion"; empty: none
    std::string module; ///< path of its library; empty: built in or unknown
    std::uint32_t controllerOf = kNoRobot; ///< a controller: index of its robot in the experiment

    bool operator==(const CallTarget&) const = default;
};

/// Written by the threads of one run; read by any thread and by signal handlers at any time. Reads take no locks, and targets live
/// as long as the monitor.
class CallMonitor {
public:
    static constexpr std::size_t kSkipped = 64; ///< targets of the last run that the present one has not, in a row
    static constexpr unsigned kThreads = 64; ///< whose calls are recorded apart; further ones share the place of the first ones

    CallMonitor() = default;
    CallMonitor(const CallMonitor&) = delete;
    CallMonitor& operator=(const CallMonitor&) = delete;

    // Writing: only the run's thread, but for the calls of a MonitoredCalls that says which thread it is on.
    /// Records which library provides a kind; used for targets added later.
    void setModule(const std::string& kind, const std::string& library) { m_modules[kind] = library; }
    const CallTarget* add(CallTarget target) {
        if (const auto module = m_modules.find(target.kind); module != m_modules.end()) target.module = module->second;
        for (std::size_t i = m_next; i < std::min(m_next + kSkipped, m_earlier); ++i)
            if (m_targets[i] == target) {
                m_next = i + 1;
                return &m_targets[i];
            }
        m_targets.push_back(std::move(target));
        return &m_targets.back();
    }
    /// Another run begins, most of whose targets will be those of the last one, in the same order.
    void beginRun() noexcept { m_next = 0, m_earlier = m_targets.size(); }
    /// Records the machine code [begin, end) of a library. The entry is kept after the library is unloaded.
    void addCode(std::uintptr_t begin, std::uintptr_t end, const CallTarget* library) {
        const std::uint32_t count = m_codeCount.load(std::memory_order_relaxed);
        for (std::uint32_t i = 0; i < count; ++i) // of an earlier run
            if (m_code[i].begin == begin && m_code[i].end == end && *m_code[i].library == *library) return;
        if (count == m_code.size()) return;
        m_code[count] = {begin, end, library};
        m_codeCount.store(count + 1, std::memory_order_release);
    }
    /// Sets the names of the bodies, indexed as in recordCluster(). Called once.
    void setBodies(std::vector<std::string> names) {
        m_bodies = std::move(names);
        m_bodyCount.store(static_cast<std::uint32_t>(m_bodies.size()), std::memory_order_release);
    }
    /// Called before a solver step: the number of contacts in the largest cluster of connected contacts, and the index of one
    /// body in it.
    void recordCluster(std::uint32_t contacts, std::uint32_t body) {
        m_clusterBody.store(body, std::memory_order_relaxed);
        m_clusterContacts.store(contacts, std::memory_order_release);
    }
    void recordTicks(std::uint64_t ticks, double time) {
        m_ticks.store(ticks, std::memory_order_relaxed);
        m_time.store(time, std::memory_order_relaxed);
    }
    /// Any thread: the run has been asked to end, so a call that does not return is not waited for.
    void askForEnd() noexcept { m_endAsked.store(true, std::memory_order_relaxed); }

    // Reading: any thread.
    /// Of the calling thread, or else of the first thread that is in a call. nullptr: neither module code nor a solver step is running.
    [[nodiscard]] const CallTarget* target() const noexcept { return running().target.load(std::memory_order_acquire); }
    [[nodiscard]] const char* doing() const noexcept { return running().doing.load(std::memory_order_acquire); } ///< "update"
    [[nodiscard]] bool endAsked() const noexcept { return m_endAsked.load(std::memory_order_relaxed); }
    /// Increases with each call that begins or ends.
    [[nodiscard]] std::uint64_t sequence() const noexcept {
        std::uint64_t sum = 0;
        for (const Lane& lane : m_lanes) sum += lane.sequence.load(std::memory_order_acquire);
        return sum;
    }
    [[nodiscard]] std::uint64_t ticks() const noexcept { return m_ticks.load(std::memory_order_relaxed); } ///< completed
    [[nodiscard]] double time() const noexcept { return m_time.load(std::memory_order_relaxed); }          ///< s, simulated
    [[nodiscard]] std::uint32_t clusterContacts() const noexcept { return m_clusterContacts.load(std::memory_order_acquire); }
    /// The library that contains this code address; nullptr: none of the recorded libraries.
    [[nodiscard]] const CallTarget* libraryAt(std::uintptr_t address) const noexcept {
        for (std::uint32_t i = m_codeCount.load(std::memory_order_acquire); i-- > 0;)
            if (address >= m_code[i].begin && address < m_code[i].end) return m_code[i].library;
        return nullptr;
    }
    /// nullptr: unknown.
    [[nodiscard]] const char* clusterBody() const noexcept {
        const std::uint32_t body = m_clusterBody.load(std::memory_order_relaxed);
        return body < m_bodyCount.load(std::memory_order_acquire) ? m_bodies[body].c_str() : nullptr;
    }

private:
    friend class MonitoredCall;
    friend class MonitoredCalls;
    /// The call of one thread, which alone writes it.
    struct alignas(64) Lane {
        std::atomic<const CallTarget*> target{nullptr};
        std::atomic<const char*> doing{""};
        std::atomic<std::uint64_t> sequence{0};

        void set(const CallTarget* called, const char* what) noexcept {
            sequence.store(sequence.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
            doing.store(what, std::memory_order_relaxed);
            target.store(called, std::memory_order_release);
        }
    };
    [[nodiscard]] Lane& own() noexcept { return m_lanes[t_lane % kThreads]; }
    [[nodiscard]] const Lane& running() const noexcept {
        const Lane& own = m_lanes[t_lane % kThreads];
        if (own.target.load(std::memory_order_acquire)) return own;
        for (const Lane& lane : m_lanes)
            if (lane.target.load(std::memory_order_acquire)) return lane;
        return own;
    }

    /// Of the calling thread, in each monitor; the run's own thread has 0.
    static inline constinit thread_local unsigned t_lane = 0;

    struct Code {
        std::uintptr_t begin = 0, end = 0;
        const CallTarget* library = nullptr;
    };

    std::array<Code, 256> m_code; ///< never moves: signal handlers read it
    std::atomic<std::uint32_t> m_codeCount{0};
    std::deque<CallTarget> m_targets;      ///< a deque, because targets must not move
    std::size_t m_next = 0, m_earlier = 0; ///< where that of earlier runs is which may be added next; their number
    std::map<std::string, std::string> m_modules;
    std::vector<std::string> m_bodies;
    std::array<Lane, kThreads> m_lanes;
    std::atomic<std::uint64_t> m_ticks{0};
    std::atomic<double> m_time{0};
    std::atomic<bool> m_endAsked{false};
    std::atomic<std::uint32_t> m_bodyCount{0}, m_clusterContacts{0}, m_clusterBody{0xffffffffu};
};

/// Marks one call into module code, or one solver step, for its lifetime. The destructor also restores the floating-point
/// environment.
class MonitoredCall {
public:
    /// `doing` is a literal: "setup", "update".
    MonitoredCall(CallMonitor& monitor, const CallTarget* target, const char* doing) noexcept
        : m_lane(monitor.own()), m_target(m_lane.target.load(std::memory_order_relaxed)),
          m_doing(m_lane.doing.load(std::memory_order_relaxed)) {
        m_lane.set(target, doing);
    }
    ~MonitoredCall() { m_lane.set(m_target, m_doing); }
    MonitoredCall(const MonitoredCall&) = delete;
    MonitoredCall& operator=(const MonitoredCall&) = delete;

private:
    friend class MonitoredCalls;

    CallMonitor::Lane& m_lane;
    const CallTarget* m_target; ///< the target before this call
    const char* m_doing;
    FloatingPointScope m_floatingPoint;
};

/// The same for many calls, one straight after another, at less than half of its cost for each.
class MonitoredCalls {
public:
    /// `thread`: the number of the calling thread in the run; 0: its own.
    MonitoredCalls(CallMonitor& monitor, const char* doing, unsigned thread = 0) noexcept
        : m_doing(doing), m_before(std::exchange(CallMonitor::t_lane, thread)), m_all(monitor, nullptr, "") {}
    ~MonitoredCalls() { CallMonitor::t_lane = m_before; }
    MonitoredCalls(const MonitoredCalls&) = delete;
    MonitoredCalls& operator=(const MonitoredCalls&) = delete;
    /// Marks the next call; the one before it has ended.
    void next(const CallTarget* target) noexcept { m_all.m_lane.set(target, m_doing); }
    /// After each call, since the next one expects it.
    void restoreFloatingPoint() const noexcept { m_all.m_floatingPoint.restore(); }

private:
    const char* m_doing;
    unsigned m_before;   ///< number of the thread; it may do the work of another one
    MonitoredCall m_all; ///< what was monitored before the first
};

} // namespace trundle
