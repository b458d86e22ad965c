#pragma once
// A device of a robot in a world, and what it can reach of that world.

#include <atomic>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <trundle/abi.h>

#include "base/call_monitor.h"
#include "model/experiment_spec.h"
#include "signals/block.h"

namespace trundle {

class DeviceTexts;
class Engine;
class WorldChargers;
class WorldLamps;
class WorldObjects;
class WorldRadio;
class WorldSupply;
struct DeviceHost;
struct WorldDevice;

/// Which calls of devices are running.
struct DevicePhase {
    std::uint64_t ticks = 0;
    enum class Calls { None, Act, Sense } calls = Calls::None;
    bool isApart = false;              ///< devices of other robots may be called at the same time
    bool keepsTexts = false;           ///< several threads call devices, so that what is printed has no order yet
    std::atomic<bool> noted = false;   ///< some device has a failure
    std::atomic<bool> printed = false; ///< some device has texts that are not passed on yet
};

/// The context of a device's TrundleServices: who calls, and when. Those of all devices lie side by side.
struct ServiceContext {
    const DeviceHost* host = nullptr;
    WorldDevice* device = nullptr;
    DevicePhase* phase = nullptr;
    std::uint32_t robot = 0;

    [[nodiscard]] bool acts() const { return phase->calls == DevicePhase::Calls::Act; }
    /// False, and the device has failed: what it asks for is shared by robots, and it said that it is independent of them.
    [[nodiscard]] bool mayShare(const char* what) const;
    [[nodiscard]] bool isCalled() const { return phase->calls != DevicePhase::Calls::None; }
};

/// Its kind, instance and signal slots.
struct WorldDevice {
    CallMonitor* calls = nullptr;     ///< outlives it
    const DeviceHost* host = nullptr; ///< from its setup on
    const TrundleKind* kind = nullptr;
    std::function<void*()> create; ///< of the instance; none: that of the kind
    const ComponentSpec* spec = nullptr;
    void* instance = nullptr;
    std::uint32_t index = 0, robot = 0;
    std::string path; ///< "robot0/leftMotor"
    const CallTarget* target = nullptr;
    std::uint64_t pathHash = 0;
    std::vector<std::uint32_t> slots; ///< slots of the kind's signals, in its order
    bool isSupply = false;            ///< of its robot
    std::vector<std::uint32_t> peers; ///< indices of the devices whose signals it bound, each once
    TrundleMount mount{};
    DevicePhase* phase = nullptr; ///< from its setup on
    std::string failure;          ///< the first failure reported
    std::string scratch;          ///< owns a text returned to the device
    std::vector<std::pair<std::int32_t, std::string>> texts; ///< printed while several devices are called at the same time

    WorldDevice() = default;
    WorldDevice(const WorldDevice&) = delete;
    WorldDevice& operator=(const WorldDevice&) = delete;
    ~WorldDevice();
    void note(const std::string& why);
    /// What its kind says went wrong, else `failure`.
    [[nodiscard]] std::string lastError() const;
};

/// The devices of a world, robot by robot, in text order.
struct DeviceList {
    std::vector<std::unique_ptr<WorldDevice>> all;
    std::vector<std::uint32_t> firstOf; ///< by robot; one more at the end

    [[nodiscard]] const WorldDevice* find(std::uint32_t robot, std::string_view name) const;
    [[nodiscard]] const WorldDevice* find(std::string_view path) const;
};

/// What devices reach of their world, all of which outlives them.
struct DeviceHost {
    const ExperimentSpec& experiment;
    Engine& engine;
    const WorldObjects& objects;
    WorldRadio& radio;
    WorldSupply& supply;
    WorldLamps& lamps;
    WorldChargers& chargers;
    SignalBlock& block;
    DeviceTexts& texts;
    const DeviceList& devices;
};

} // namespace trundle
