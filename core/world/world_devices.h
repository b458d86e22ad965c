#pragma once
// The devices of a world: created of their kinds' tables, initialised with their fields, bound to joints, geoms and each other,
// and called in each tick.

#include <span>

#include "base/diagnostic.h"
#include "signals/layout.h"
#include "world/phase_calls.h"
#include "world/world.h"

namespace trundle {

struct BuiltRobot;
struct GivenField;

class WorldDevices {
public:
    /// The monitor outlives this.
    explicit WorldDevices(CallMonitor& calls) : m_calls(calls) {}

    // Building, in this order. What fails is reported.
    void create(std::span<const BuiltRobot> robots, const DeviceCode& code, Diagnostics& diagnostics);
    /// Adds the signals of one robot's devices.
    void layOut(std::uint32_t robot, const RobotConfigSpec& config, SignalLayout& layout);
    /// Of a robot with the config and the signals of `equal`, whose slots lie `shift` further.
    void layOutLike(std::uint32_t robot, std::uint32_t equal, std::uint32_t shift);
    void setup(const DeviceHost& host, Diagnostics& diagnostics);
    /// Devices act before the peers whose signals they bound, and sense after them.
    void order(Diagnostics& diagnostics);

    // The device that failed, nullptr if none: its `failure` says why.
    /// Before the first sense: Leds shine from the start, so that the first reading of a light sensor is that of their light.
    [[nodiscard]] const WorldDevice* shine() { return callAll(0, DevicePhase::Calls::Act, m_leds); }
    // The calls of a tick, after `ticks` of them.
    [[nodiscard]] const WorldDevice* act(std::uint64_t ticks) { return callAll(ticks, DevicePhase::Calls::Act, m_acting); }
    [[nodiscard]] const WorldDevice* sense(std::uint64_t ticks) { return callAll(ticks, DevicePhase::Calls::Sense, m_sensing); }

    /// The devices of a robot are not called any more.
    void end(std::uint32_t robot) {
        m_acting.remove(robot);
        m_sensing.remove(robot);
    }

    [[nodiscard]] const DeviceList& list() const { return m_devices; }

private:
    [[nodiscard]] std::unique_ptr<WorldDevice> made(const BuiltRobot& robot, const ComponentSpec& spec, std::uint32_t robotIndex,
                                                    const DeviceCode& code, Diagnostics& diagnostics);
    void instantiate(WorldDevice& device, Diagnostics& diagnostics);
    [[nodiscard]] static bool giveFields(WorldDevice& device, std::span<const GivenField> fields, Diagnostics& diagnostics);
    [[nodiscard]] bool hasRoom(const WorldDevice& device, Diagnostics& diagnostics);
    [[nodiscard]] std::vector<bool> independent(const std::vector<std::uint32_t>& order,
                                                const std::vector<std::vector<std::uint32_t>>& before) const;
    void addSupplies(std::vector<std::vector<std::uint32_t>>& next) const;
    void reportCircle(const std::vector<std::uint32_t>& acting, Diagnostics& diagnostics) const;
    [[nodiscard]] const WorldDevice* callAll(std::uint64_t ticks, DevicePhase::Calls phase, const PhaseCalls& calls);

    CallMonitor& m_calls;
    DevicePhase m_phase; ///< outlives the devices
    DeviceList m_devices;
    std::vector<ServiceContext> m_contexts; ///< by device
    PhaseCalls m_acting, m_sensing;         ///< without devices that lack the function
    PhaseCalls m_leds;                      ///< of m_acting
    std::vector<ThreadServices> m_services; ///< by thread; one for all its calls, which stays in its cache
    double m_tick = 0;                      ///< s
    std::uint64_t m_numbers = 0;            ///< in the signals of all devices
};

} // namespace trundle
