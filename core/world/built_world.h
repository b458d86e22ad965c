#pragma once
// Implementation of World. Building: world_build.cpp and device_mount.cpp; ticks: world_tick.cpp and device_services.cpp; reading
// and external commands: world_state.cpp; radio: world_radio.cpp; faults: world_fault.cpp.

#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "radio/medium.h"
#include "world/engine.h"
#include "world/world.h"

namespace trundle {

class BuiltWorld;

/// A device of a robot: its kind, instance and signal slots.
struct Device {
    BuiltWorld* world = nullptr;
    const TrundleKind* kind = nullptr;
    const ComponentSpec* spec = nullptr;
    void* instance = nullptr;
    std::uint32_t index = 0, robot = 0;
    std::string path; ///< "robot0/leftMotor"
    const CallTarget* target = nullptr;
    std::uint64_t pathHash = 0;
    std::vector<std::uint32_t> slots; ///< slots of the kind's signals, in its order
    std::vector<std::uint32_t> peers; ///< indices of the devices whose signals it bound, each once
    TrundleMount mount{};
    std::string failure; ///< the first failure reported
    std::string scratch; ///< owns a text returned to the device

    Device() = default;
    Device(const Device&) = delete;
    Device& operator=(const Device&) = delete;
    ~Device();
    void note(const std::string& why);
};

/// One call of a device's act or sense, stored contiguously for the tick.
struct DeviceCall {
    std::int32_t (*run)(void*, const TrundleServices*) = nullptr;
    void* instance = nullptr;
    Device* device = nullptr;
};

/// A robot in the engine, with the location of its signals.
struct BuiltRobot {
    const RobotSpec* spec = nullptr;
    ActorHandles handles;
    Pose frameInFirst;          ///< pose of the config frame in the first body's frame
    bool frameIsFirst = false;  ///< frameInFirst is the identity
    std::optional<Vec3> centre; ///< of a passive object: centre of mass of its first body in the config frame
    std::uint32_t image = 0;    ///< first slot of its signals
    std::uint32_t firstDevice = 0, deviceCount = 0;
};

/// Text that a device printed before a listener was set.
struct SetupText {
    std::string path;
    int severity = 0;
    std::string text;
};

/// Anchor and axis of a joint in its parent's frame.
struct JointLocation {
    std::uint32_t parent = 0; ///< engine body; valid only if `carried`
    bool carried = false;     ///< false: attached to the world; anchor and axis are in world coordinates
    Vec3 anchor = Vec3::Zero(), axis = Vec3::UnitZ();
};

/// Position of a radio on its robot.
struct RadioMount {
    std::uint32_t body = 0, robot = 0; ///< body: engine body
    Pose mount;                        ///< pose of the antenna in the body's frame
};

class BuiltWorld final : public World {
public:
    BuiltWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls);
    ~BuiltWorld() override;

    /// Implements World::build; false if the world cannot be built.
    [[nodiscard]] bool build(const DeviceCode& devices, Diagnostics& diagnostics);

    [[nodiscard]] const ExperimentSpec& experiment() const override { return *m_experiment; }
    [[nodiscard]] const SignalLayout& layout() const override { return m_layout; }
    [[nodiscard]] SignalBlock& block() override { return *m_block; }
    [[nodiscard]] const SignalBlock& block() const override { return *m_block; }
    [[nodiscard]] Status tick() override;
    [[nodiscard]] const Fault* fault() const override { return m_fault ? &*m_fault : nullptr; }
    [[nodiscard]] std::uint64_t ticks() const override { return m_ticks; }
    [[nodiscard]] std::uint64_t quickTicks() const override { return m_engine->quickTicks(); }
    [[nodiscard]] std::uint64_t rescuedTicks() const override { return m_engine->rescuedTicks(); }
    [[nodiscard]] std::size_t largestExactCluster() const override { return m_engine->largestExactCluster(); }
    [[nodiscard]] SweepReport sweeps() const override;
    [[nodiscard]] std::uint64_t stateHash() const override;
    [[nodiscard]] Pose robotPose(std::size_t robot) const override;
    [[nodiscard]] Pose reportedPose(std::size_t robot) const override;
    [[nodiscard]] RobotEnergy robotEnergy(std::size_t robot) const override;
    [[nodiscard]] const std::vector<WorldContact>& contacts() const override;
    [[nodiscard]] Medium* medium() const override { return m_medium.get(); }
    [[nodiscard]] Status push(const std::string& body, const Vec3& force, const Vec3& point) override;
    [[nodiscard]] Status place(const std::string& robot, const Pose& pose) override;
    [[nodiscard]] Status setSurface(const SurfaceSpec& surface) override;
    [[nodiscard]] Status setProperty(const std::string& device, const std::string& property, const PropertyValue& value) override;
    void setDeviceText(DeviceText text) override;

private:
    friend struct Device;
    friend struct MountCalls;
    friend struct RadioCalls;
    friend struct ServiceCalls;

    // world_build.cpp
    void buildScenery(Diagnostics& diagnostics);
    void buildRobots(Diagnostics& diagnostics);
    void nameBodies();
    [[nodiscard]] static JointLocation placeOf(const JointSpec& joint, const BuiltRobot& robot);
    void layOutSignals();
    void layOutDevice(Device& device);

    // device_mount.cpp
    void createDevices(const DeviceCode& code, Diagnostics& diagnostics);
    [[nodiscard]] bool giveFields(Device& device, Diagnostics& diagnostics);
    void setupDevices(Diagnostics& diagnostics);
    void orderDevices(Diagnostics& diagnostics);
    [[nodiscard]] Device* deviceNamed(const BuiltRobot& robot, std::string_view name);
    void print(const Device& device, int severity, const char* text);

    // world_radio.cpp
    void openMedium();
    void placeRadios();
    void airTime();
    [[nodiscard]] int solids(RadioId first, const Vec3& a, RadioId second, const Vec3& b) const;

    // world_tick.cpp
    [[nodiscard]] std::optional<EngineFault> stepEngine();
    [[nodiscard]] bool callDevices(bool acting);
    [[nodiscard]] bool failed(Device& device);
    void publish();
    void publishRobot(const BuiltRobot& robot, double* slots) const;

    // world_fault.cpp
    [[nodiscard]] std::pair<const BuiltRobot*, std::size_t> ownerOf(BodyHandle body) const; ///< and the body's index in it
    [[nodiscard]] std::string faultAdvice(BodyHandle body) const;
    [[nodiscard]] Status stopAt(const EngineFault& fault);
    [[nodiscard]] Status stop(Code code, Fault fault);
    [[nodiscard]] Status stopped() const;
    [[nodiscard]] Pose framePose(const BuiltRobot& robot) const;
    [[nodiscard]] Pose centredPose(const BuiltRobot& robot) const; ///< see World::reportedPose

    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<CallMonitor> m_calls; ///< declared before the devices, whose destructor calls it monitors
    const CallTarget* m_solver = nullptr;
    std::unique_ptr<Engine> m_engine;
    SignalLayout m_layout;
    std::unique_ptr<SignalBlock> m_block;
    std::vector<BuiltRobot> m_robots;               ///< in the order of the experiment
    std::vector<std::unique_ptr<Device>> m_devices; ///< robot by robot, in text order
    std::vector<DeviceCall> m_acting, m_sensing;    ///< in calling order; without devices that lack the function
    std::vector<std::string> m_geomPaths;           ///< by engine geom
    std::vector<std::string> m_bodyPaths;           ///< by engine body
    std::vector<SourceRange> m_bodyRanges;
    std::vector<std::uint32_t> m_hashOrder;                                     ///< engine bodies, sorted by path
    std::unordered_map<std::string, std::uint32_t> m_bodyByPath, m_robotByName; // for lookup only, never iterated
    std::vector<std::uint8_t> m_jointTurns;                                     ///< by engine joint: whether it has a position
    std::vector<JointLocation> m_jointLocations;                                ///< by engine joint

    std::unique_ptr<Medium> m_medium;
    std::vector<RadioMount> m_radioMounts; ///< by radio

    TrundleServices m_services{};
    Device* m_current = nullptr; ///< the device whose act or sense is running
    bool m_inAct = false, m_deviceNoted = false; ///< noted: some device has reported a failure
    DeviceText m_deviceText;
    std::vector<SetupText> m_earlyTexts;

    std::uint64_t m_ticks = 0;
    std::optional<Fault> m_fault;
    Code m_faultCode = Code::BlowUp;
    mutable std::vector<WorldContact> m_contacts;
    mutable bool m_contactsReady = false;
};

/// Fills the function tables passed to devices.
void fillServices(TrundleServices& services, BuiltWorld& world, double tick);
void fillMount(Device& device, double tick);
[[nodiscard]] const TrundleMountRadio* mountRadio();
[[nodiscard]] const TrundleServicesRadio* servicesRadio();

/// "leftAxle, rightAxle": joins the names of a list.
template <class List> std::string namesOf(const List& list) {
    std::string out;
    for (const auto& item : list) out += (out.empty() ? "" : ", ") + item.name;
    return out.empty() ? "none" : out;
}

} // namespace trundle
