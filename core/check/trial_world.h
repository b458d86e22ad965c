#pragma once
// Private to core/check. One robot alone on a plain floor, with its motors and drives, without its controllers and sensors.

#include <memory>
#include <stop_token>
#include <string>

#include "world/world.h"

namespace trundle {

class TrialWorld {
public:
    /// The robot stands with its lowest point on the floor; the axis of its frame that is most upright at its start is upright.
    /// `robot` and `experiment` must outlive the result. Nothing if a kind is not built in, or it cannot be built.
    [[nodiscard]] static std::unique_ptr<TrialWorld> build(const ExperimentSpec& experiment, const RobotSpec& robot);

    /// False if the world has a fault or is too much work (kMostWork), or a stop was requested.
    [[nodiscard]] bool run(double seconds, const std::stop_token& stop);
    /// A command of a device, in SI units; nothing happens if it has none with that name.
    void command(const std::string& device, const char* signal, double value);
    /// A value of the robot, as "shoulder/position"; 0 if there is none.
    [[nodiscard]] double value(const std::string& path, std::size_t index = 0) const;
    [[nodiscard]] Pose pose() const { return m_world->robotPose(0); } ///< of the robot
    [[nodiscard]] Pose bodyPose(const BodySpec& body) const;
    [[nodiscard]] Vec3 velocity(const BodySpec& body) const; ///< m/s, in the world
    /// Whether the robot was torn apart or flew off.
    [[nodiscard]] const Fault* fault() const;

private:
    explicit TrialWorld(std::unique_ptr<World> world) : m_world(std::move(world)) {}

    std::unique_ptr<World> m_world;
    std::uint64_t m_work = 0; ///< bodies times ticks so far
};

} // namespace trundle
