#pragma once
// The calls of one phase of a tick, act or sense. First those of devices that are independent of other robots (TRUNDLE_INDEPENDENT), and of
// all devices that come before them: robot by robot, those of several robots at the same time where there are threads. Then all
// others, one after another, in their order. What is called when depends on nothing but the experiment, so that a run is the same with
// any number of threads.

#include <vector>

#include "world/world_device.h"

namespace trundle {

class WorkTeam;

/// Of a device's act or sense.
struct DeviceCall {
    std::int32_t (*run)(void*, const TrundleServices*) = nullptr;
    void* instance = nullptr;
    ServiceContext* context = nullptr;
    const CallTarget* target = nullptr;
};

/// One thread's table, whose context is that of the device that it calls.
struct alignas(64) ThreadServices {
    TrundleServices table{};
};

class PhaseCalls {
public:
    /// In the order of the calls of each robot. `independent`: also of all calls before it that it waits for.
    void add(const DeviceCall& call, bool independent) { (independent ? m_apart : m_others).push_back(call); }
    /// After the last one.
    void arrange();
    /// The devices of a robot are not called any more.
    void remove(std::uint32_t robot);

    /// What all calls of a phase share.
    struct Round {
        CallMonitor& calls;
        DevicePhase& phase;
        std::vector<ThreadServices>& services; ///< by thread
        WorkTeam* team = nullptr;              ///< nullptr: one thread
    };
    /// Returns the first device that failed, nullptr if none: its `failure` says why.
    [[nodiscard]] const WorldDevice* run(const Round& round) const;

private:
    /// With `stop` it ends at the first device that fails, and returns that; else it calls all and returns nullptr.
    static const WorldDevice* call(const Round& round, unsigned thread, const DeviceCall* begin, const DeviceCall* end,
                                   bool stop);
    static void passTexts(const DeviceCall& call);

    std::vector<DeviceCall> m_apart, m_others; ///< m_apart: robot by robot
    std::vector<std::uint32_t> m_robots;       ///< first call of each robot in m_apart; one more at the end
};

} // namespace trundle
