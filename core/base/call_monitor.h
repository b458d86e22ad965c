#pragma once
// What a run is busy with, for whoever has to say it when the run itself cannot: another thread, or the handler of a crash.

#include <array>
#include <atomic>
#include <cstdint>
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "base/floating_point.h"

namespace trundle {

/// Whose code is called.
struct CallTarget {
    static constexpr std::uint32_t kNoRobot = 0xffffffffu;

    std::string text;   ///< "the controller LinearMotion of robot0", "the device robot0/spinner", "the module libx.so"
    std::string robot;  ///< "robot0"; empty: none
    std::string kind;   ///< "LinearMotion"; empty: none
    std::string module; ///< path of its library; empty: built in, or not known
    std::uint32_t controllerOf = kNoRobot; ///< a controller: its robot's place in the experiment
};

/// Written by the thread of one run, read by any other at any time and by signal handlers: what they read has no locks, and targets
/// stay as long as the monitor.
class CallMonitor {
public:
    CallMonitor() = default;
    CallMonitor(const CallMonitor&) = delete;
    CallMonitor& operator=(const CallMonitor&) = delete;

    // By the run's thread.
    /// From which library a kind comes; for the targets that are added later.
    void setModule(const std::string& kind, const std::string& library) { m_modules[kind] = library; }
    const CallTarget* add(CallTarget target) {
        if (const auto module = m_modules.find(target.kind); module != m_modules.end()) target.module = module->second;
        m_targets.push_back(std::move(target));
        return &m_targets.back();
    }
    /// The machine code of a library, from `begin` up to `end`. It stays known when the library is gone.
    void addCode(std::uintptr_t begin, std::uintptr_t end, const CallTarget* library) {
        const std::uint32_t count = m_codeCount.load(std::memory_order_relaxed);
        if (count == m_code.size()) return;
        m_code[count] = {begin, end, library};
        m_codeCount.store(count + 1, std::memory_order_release);
    }
    /// The names of the bodies, as noteCluster() counts them. Once.
    void setBodies(std::vector<std::string> names) {
        m_bodies = std::move(names);
        m_bodyCount.store(static_cast<std::uint32_t>(m_bodies.size()), std::memory_order_release);
    }
    /// Before a step of the solver: how many contacts hang together in the largest cluster, and one body in it.
    void noteCluster(std::uint32_t contacts, std::uint32_t body) {
        m_clusterBody.store(body, std::memory_order_relaxed);
        m_clusterContacts.store(contacts, std::memory_order_release);
    }
    void noteTicks(std::uint64_t ticks, double time) {
        m_ticks.store(ticks, std::memory_order_relaxed);
        m_time.store(time, std::memory_order_relaxed);
    }

    // By anybody.
    /// nullptr: no code of others, and no step of the solver.
    [[nodiscard]] const CallTarget* target() const noexcept { return m_target.load(std::memory_order_acquire); }
    [[nodiscard]] const char* doing() const noexcept { return m_doing.load(std::memory_order_acquire); } ///< "update"
    /// Changes with each call that begins or ends.
    [[nodiscard]] std::uint64_t sequence() const noexcept { return m_sequence.load(std::memory_order_acquire); }
    [[nodiscard]] std::uint64_t ticks() const noexcept { return m_ticks.load(std::memory_order_relaxed); } ///< completed
    [[nodiscard]] double time() const noexcept { return m_time.load(std::memory_order_relaxed); }          ///< s, simulated
    [[nodiscard]] std::uint32_t clusterContacts() const noexcept { return m_clusterContacts.load(std::memory_order_acquire); }
    /// The library whose code is there; nullptr: none of those that are known.
    [[nodiscard]] const CallTarget* libraryAt(std::uintptr_t address) const noexcept {
        for (std::uint32_t i = m_codeCount.load(std::memory_order_acquire); i-- > 0;)
            if (address >= m_code[i].begin && address < m_code[i].end) return m_code[i].library;
        return nullptr;
    }
    /// nullptr: not known.
    [[nodiscard]] const char* clusterBody() const noexcept {
        const std::uint32_t body = m_clusterBody.load(std::memory_order_relaxed);
        return body < m_bodyCount.load(std::memory_order_acquire) ? m_bodies[body].c_str() : nullptr;
    }

private:
    friend class MonitoredCall;
    void set(const CallTarget* target, const char* doing) noexcept {
        m_sequence.store(m_sequence.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        m_doing.store(doing, std::memory_order_relaxed);
        m_target.store(target, std::memory_order_release);
    }

    struct Code {
        std::uintptr_t begin = 0, end = 0;
        const CallTarget* library = nullptr;
    };

    std::array<Code, 256> m_code; ///< never moves: handlers of signals read it
    std::atomic<std::uint32_t> m_codeCount{0};
    std::deque<CallTarget> m_targets; ///< none of them moves
    std::map<std::string, std::string> m_modules;
    std::vector<std::string> m_bodies;
    std::atomic<const CallTarget*> m_target{nullptr};
    std::atomic<const char*> m_doing{""};
    std::atomic<std::uint64_t> m_sequence{0}, m_ticks{0};
    std::atomic<double> m_time{0};
    std::atomic<std::uint32_t> m_bodyCount{0}, m_clusterContacts{0}, m_clusterBody{0xffffffffu};
};

/// One call into code of a module, or one step of the solver, as long as it lasts. What it does to the floating-point environment ends
/// with it.
class MonitoredCall {
public:
    /// `doing` is a literal: "setup", "update".
    MonitoredCall(CallMonitor& monitor, const CallTarget* target, const char* doing) noexcept
        : m_monitor(monitor), m_target(monitor.m_target.load(std::memory_order_relaxed)),
          m_doing(monitor.m_doing.load(std::memory_order_relaxed)) {
        m_monitor.set(target, doing);
    }
    ~MonitoredCall() { m_monitor.set(m_target, m_doing); }
    MonitoredCall(const MonitoredCall&) = delete;
    MonitoredCall& operator=(const MonitoredCall&) = delete;

private:
    CallMonitor& m_monitor;
    const CallTarget* m_target; ///< before it
    const char* m_doing;
    FloatingPointScope m_floatingPoint;
};

} // namespace trundle
