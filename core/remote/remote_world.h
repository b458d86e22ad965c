#pragma once
// A world with one robot whose body is elsewhere: a served run or a real robot.

#include <memory>
#include <vector>

#include "remote/robot_link.h"
#include "world/world.h"

namespace trundle {

/// The text says which devices the robot has; a tick sends what its controller has commanded and takes over what the robot has measured. So a run
/// of it has the same controllers, logs and ends as in simulation.
class RemoteWorld final : public World {
public:
    /// `described`: a world with that robot alone, which gives layout and block and is never ticked.
    RemoteWorld(std::unique_ptr<World> described, std::unique_ptr<RobotLink> link);

    /// Outputs and commands of the text that the robot does not have: outputs stay as they are at the start, commands have no effect.
    [[nodiscard]] const std::vector<std::string>& missing() const { return m_missing; }
    [[nodiscard]] RobotLink& link() { return *m_link; }

    [[nodiscard]] Status tick() override;
    [[nodiscard]] std::uint64_t ticks() const override { return m_ticks; }
    [[nodiscard]] const Fault* fault() const override { return nullptr; }
    /// Its ground truth where there is one, else where its odometry has got to from its pose in the text.
    [[nodiscard]] Pose robotPose(std::size_t robot) const override;

    [[nodiscard]] const ExperimentSpec& experiment() const override { return m_described->experiment(); }
    [[nodiscard]] const SignalLayout& layout() const override { return m_described->layout(); }
    [[nodiscard]] SignalBlock& block() override { return m_described->block(); }
    [[nodiscard]] const SignalBlock& block() const override { return std::as_const(*m_described).block(); }
    void setDeviceText(DeviceText text) override { m_described->setDeviceText(std::move(text)); }

    // What only a simulation has.
    [[nodiscard]] std::uint64_t stateHash() const override { return 0; }
    [[nodiscard]] RobotEnergy robotEnergy(std::size_t) const override { return {}; }
    [[nodiscard]] const std::vector<WorldContact>& contacts() const override { return m_contacts; }
    [[nodiscard]] Status push(const std::string&, const Vec3&, const Vec3&) override { return refused(); }
    [[nodiscard]] Status place(const std::string&, const Pose&) override { return refused(); }
    [[nodiscard]] Status setSurface(const SurfaceSpec&) override { return refused(); }
    [[nodiscard]] Status setProperty(const std::string&, const std::string&, const PropertyValue&) override { return refused(); }

private:
    struct Span {
        std::size_t here, there, count; ///< slots of the block, values of the link
    };
    struct CommandOf {
        std::size_t here;
        std::size_t there;
        std::string path;
        std::vector<double> known; ///< at the other end
    };
    void join();
    [[nodiscard]] bool isPublished(const std::string& path) const;
    void takeValues();
    [[nodiscard]] static Error refused();

    std::unique_ptr<World> m_described;
    std::unique_ptr<RobotLink> m_link;
    std::vector<Span> m_read;
    std::vector<CommandOf> m_commands;
    std::vector<std::string> m_missing;
    std::vector<WorldContact> m_contacts;
    std::optional<std::uint32_t> m_pose, m_odometry; ///< slots
    std::uint64_t m_ticks = 0;
};

} // namespace trundle
