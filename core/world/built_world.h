#pragma once
// Implementation of World: the order of a tick, and what is read and commanded between ticks. The work is done by its parts:
//
//   WorldObjects   robots and scenery in the engine, and what its handles stand for
//   WorldDevices   devices: created, set up, called; what they can reach is a DeviceHost
//   WorldRadio     the medium between the radios of devices
//   WorldSupply    batteries, and what devices draw;  WorldChargers: what charges them;  WorldLamps: the lamps that devices are
//   WorldRegions   which robots are in its regions
//   RobotSignals   the layout of the block, and the states in it
//
// Building: world_build.cpp; ticks: world_tick.cpp; reading, commands, faults: world_state.cpp.

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "model/joined_robots.h"
#include "world/device_texts.h"
#include "world/robot_signals.h"
#include "world/world_chargers.h"
#include "world/world_fault.h"
#include "world/world_lamps.h"
#include "world/world_radio.h"
#include "world/world_regions.h"
#include "world/world_supply.h"

namespace trundle {

class BuiltWorld final : public World {
public:
    BuiltWorld(std::shared_ptr<const ExperimentSpec> experiment, std::shared_ptr<CallMonitor> calls,
               std::unique_ptr<Engine> engine);
    ~BuiltWorld() override;

    /// Implements World::build in an engine with nothing in it; false if the world cannot be built.
    [[nodiscard]] bool build(const DeviceCode& code, Diagnostics& diagnostics);

    [[nodiscard]] const ExperimentSpec& experiment() const override { return *m_experiment; }
    [[nodiscard]] const SignalLayout& layout() const override { return m_layout; }
    [[nodiscard]] SignalBlock& block() override { return *m_block; }
    [[nodiscard]] const SignalBlock& block() const override { return *m_block; }
    [[nodiscard]] Status tick() override;
    [[nodiscard]] WorkTeam* threads() override { return m_engine->threads(false); }
    [[nodiscard]] const Fault* fault() const override { return m_fault ? &*m_fault : nullptr; }
    [[nodiscard]] const RobotFaultReport& robotFaults() const override { return m_robotFaults.report(); }
    [[nodiscard]] std::uint64_t ticks() const override { return m_ticks; }
    [[nodiscard]] EngineSolves solves() const override { return m_engine->solves(); }
    [[nodiscard]] SweepReport sweeps() const override;
    [[nodiscard]] std::uint64_t stateHash() const override;
    [[nodiscard]] Pose robotPose(std::size_t robot) const override;
    [[nodiscard]] Pose reportedPose(std::size_t robot) const override;
    [[nodiscard]] RobotEnergy robotEnergy(std::size_t robot) const override;
    [[nodiscard]] const std::vector<WorldContact>& contacts() const override;
    [[nodiscard]] Medium* medium() const override { return &m_radio.medium(); }
    [[nodiscard]] Status push(const std::string& body, const Vec3& force, const Vec3& point) override;
    [[nodiscard]] Status place(const std::string& robot, const Pose& pose) override;
    [[nodiscard]] Status setSurface(const SurfaceSpec& surface) override;
    [[nodiscard]] Status setProperty(const std::string& device, const std::string& property, const PropertyValue& value) override;
    void setDeviceText(DeviceText text) override { m_texts.setListener(std::move(text)); }

private:
    // world_tick.cpp
    [[nodiscard]] Status advance();
    [[nodiscard]] std::optional<EngineFault> stepEngine();
    [[nodiscard]] Status endRobots();
    void placeRobots();
    void publish();

    // world_state.cpp
    [[nodiscard]] Pose framePose(const BuiltRobot& robot) const;
    [[nodiscard]] Status stopAt(const EngineFault& fault);
    [[nodiscard]] Status stopAt(const WorldDevice& failed);
    [[nodiscard]] Status stop(Code code, Fault fault);
    [[nodiscard]] Status stopped() const;

    std::shared_ptr<const ExperimentSpec> m_experiment;
    std::shared_ptr<CallMonitor> m_calls; ///< declared before the devices, whose destructor calls it monitors
    const CallTarget* m_solver;
    std::unique_ptr<Engine> m_engine;
    WorldObjects m_objects;
    JoinedRobots m_joined{*m_experiment};
    mutable WorldRadio m_radio{*m_experiment, *m_engine, m_objects}; ///< mutable: see World::medium()
    WorldSupply m_supply;
    WorldLamps m_lamps;
    WorldChargers m_chargers;
    DeviceTexts m_texts;
    WorldRegions m_regions{*m_experiment, m_texts};
    SignalLayout m_layout;
    std::unique_ptr<SignalBlock> m_block;
    std::optional<DeviceHost> m_host; ///< once the block is there
    WorldDevices m_devices{*m_calls}; ///< destroyed before all that devices reach
    RobotSignals m_signals;

    std::map<std::size_t, Pose>
        m_placed; ///< by robot: how it is moved in the coming tick; of several placements the last one counts
    std::uint64_t m_ticks = 0;
    std::optional<Fault> m_fault;
    RobotFaults m_robotFaults;
    Code m_faultCode = Code::BlowUp;
    mutable std::vector<WorldContact> m_contacts;
    mutable bool m_contactsReady = false;
};

} // namespace trundle
