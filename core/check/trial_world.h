#pragma once
// Private to core/check. One robot alone on a plain floor, with its motors and drives, without its controllers and sensors.

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

#include "world/world.h"

namespace trundle {

using TrialTime = std::chrono::steady_clock::time_point;

class TrialWorld {
public:
    /// The robot stands with its lowest point on the floor; the axis of its frame that is most upright at its start is upright.
    /// `robot` and `experiment` must outlive the result. Nothing if a kind is not built in, or it cannot be
    /// built or has too many bodies.
    [[nodiscard]] static std::unique_ptr<TrialWorld> build(const ExperimentSpec& experiment, const RobotSpec& robot,
                                                           TrialTime end);

    /// False if the world has a fault, a stop was requested, or `end` has passed.
    [[nodiscard]] bool run(double seconds, const std::stop_token& stop);
    /// A command of a device, in SI units; nothing happens if it has none with that name.
    void command(const std::string& device, const char* signal, double value);
    /// A value of the robot, as "shoulder/position"; 0 of an unknown path.
    [[nodiscard]] double value(const std::string& path, std::size_t index = 0) const;
    /// What carries the wheels of its drive, or the heaviest body.
    [[nodiscard]] const BodySpec& base() const;
    /// Of the frame that is fixed to the base and was that of the config at the start.
    [[nodiscard]] Pose pose() const { return bodyPose(base()) * base().pose.inverse(); }
    [[nodiscard]] Pose bodyPose(const BodySpec& body) const;
    [[nodiscard]] Vec3 velocity(const BodySpec& body) const;                                       ///< m/s, in the world
    [[nodiscard]] double gravity() const { return m_world->experiment().settings.gravity.norm(); } ///< m/s^2
    [[nodiscard]] const SurfaceSpec& surface(const GeomSpec& geom) const { return m_world->experiment().surfaces[geom.surface]; }
    /// N, by which the floor holds a body.
    [[nodiscard]] double loadOf(const BodySpec& body) const;
    /// Whether the robot was torn apart or flew off.
    [[nodiscard]] const Fault* fault() const;

private:
    TrialWorld(std::unique_ptr<World> world, std::size_t base, TrialTime end)
        : m_world(std::move(world)), m_base(base), m_end(end) {}

    std::unique_ptr<World> m_world;
    std::size_t m_base = 0;
    TrialTime m_end;
};

} // namespace trundle
