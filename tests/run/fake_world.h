#pragma once
// A world without physics for tests of the code that uses a world: robots slide along +x at 1 m/s.

#include <map>

#include "base/platform/work_team.h"
#include "world/world.h"

namespace trundle {

class FakeWorld : public World {
public:
    explicit FakeWorld(std::shared_ptr<const ExperimentSpec> experiment)
        : m_experiment(std::move(experiment)), m_layout(layoutOf(*m_experiment)), m_block(m_layout) {}

    const ExperimentSpec& experiment() const override { return *m_experiment; }
    const SignalLayout& layout() const override { return m_layout; }
    SignalBlock& block() override { return m_block; }
    const SignalBlock& block() const override { return m_block; }
    Status tick() override {
        if (m_ticks == faultAt) {
            m_fault = Fault{"robot0/chassis", time(), "too fast", {}};
            return Error{Code::BlowUp, "robot0/chassis blew up"};
        }
        ++m_ticks;
        story += "step ";
        return {};
    }
    WorkTeam* threads() override { return team.get(); }
    const Fault* fault() const override { return m_fault ? &*m_fault : nullptr; }
    std::uint64_t ticks() const override { return m_ticks; }
    EngineSolves solves() const override { return {quick, rescued, cluster}; }
    SweepReport sweeps() const override { return swept; }
    std::uint64_t stateHash() const override { return m_ticks; }
    Pose robotPose(std::size_t robot) const override { return {{time(), static_cast<double>(robot), 0}, Quat::Identity()}; }
    RobotEnergy robotEnergy(std::size_t) const override { return {0.5, 2}; }
    const std::vector<WorldContact>& contacts() const override { return touching; }
    const RobotFaultReport& robotFaults() const override { return faults; }
    Status push(const std::string& body, const Vec3&, const Vec3&) override { return take("push " + body); }
    Status place(const std::string& robot, const Pose&) override { return take("place " + robot); }
    Status setSurface(const SurfaceSpec& surface) override { return take("surface " + surface.name); }
    Status setProperty(const std::string& device, const std::string& property, const PropertyValue&) override {
        return take("set " + device + "." + property);
    }
    void setDeviceText(DeviceText text) override { say = std::move(text); }

    std::uint64_t faultAt = ~0ull;
    std::string story; ///< calls in order
    std::vector<WorldContact> touching;
    std::size_t cluster = 0;
    std::uint64_t quick = 0, rescued = 0;
    SweepReport swept;
    RobotFaultReport faults;
    DeviceText say;
    std::unique_ptr<WorkTeam> team; ///< null: one thread

private:
    static SignalLayout layoutOf(const ExperimentSpec& experiment) {
        SignalLayout layout;
        for (const RobotSpec& robot : experiment.robots) {
            layout.beginRobot(robot.name);
            layout.add("pose", "m", SignalType::Real, SignalDirection::Truth, 7);
            layout.add("arm/position", "rad", SignalType::Real, SignalDirection::Truth);
            layout.add("base/linearVelocity", "m/s", SignalType::Real, SignalDirection::Command);
            layout.add("touch/pressed", "", SignalType::Boolean, SignalDirection::Output);
        }
        return layout;
    }
    Status take(const std::string& what) {
        if (what.find("nobody") != std::string::npos) return Error{Code::NoSuchPath, "there is no nobody"};
        story += what + " ";
        return {};
    }

    std::shared_ptr<const ExperimentSpec> m_experiment;
    SignalLayout m_layout;
    SignalBlock m_block;
    std::optional<Fault> m_fault;
    std::uint64_t m_ticks = 0;
};

/// An experiment of robots without bodies, tick 0.01 s.
inline std::shared_ptr<ExperimentSpec> experimentOf(const std::vector<std::string>& robots) {
    auto experiment = std::make_shared<ExperimentSpec>();
    for (const std::string& name : robots) {
        RobotSpec robot;
        robot.name = name;
        robot.config = std::make_shared<RobotConfigSpec>();
        experiment->robots.push_back(robot);
    }
    return experiment;
}

inline ResolvedValue numberValue(double number) { return {{PropertyType::Number, {number}, {}}, {}, Origin::Instance}; }
inline ResolvedValue textValue(std::vector<std::string> texts) {
    return {{PropertyType::Text, {}, std::move(texts)}, {}, Origin::Instance};
}

inline ComponentSpec logSpec(std::string kind, std::string name, std::map<std::string, ResolvedValue, std::less<>> values) {
    return {std::move(kind), std::move(name), std::move(values), {}, {}};
}

} // namespace trundle
