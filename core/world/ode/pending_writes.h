#pragma once
// Writes that wait for the next step.

#include <span>
#include <vector>

#include "world/ode/objects/ode_objects.h"

namespace trundle {

class PendingWrites {
public:
    void addTorque(std::uint32_t joint, double torque) { m_torques.push_back({joint, torque}); }
    void addForce(std::uint32_t body, const Vec3& force, const Vec3& point) { m_forces.push_back({body, force, point}); }
    /// Moves a whole actor with its own joints to the world, and sets its velocities to zero.
    void addMotion(std::uint32_t actor, const Pose& motion) { m_motions.push_back({actor, motion}); }

    /// Does all of them, first the motions, and gives the actors that were moved.
    /// Valid until the next call.
    [[nodiscard]] std::span<const std::uint32_t> apply(OdeObjects& objects);

private:
    struct JointTorque {
        std::uint32_t joint;
        double torque;
    };
    struct BodyForce {
        std::uint32_t body;
        Vec3 force, point;
    };
    struct ActorMotion {
        std::uint32_t actor;
        Pose motion;
    };
    static void move(OdeObjects& objects, const ActorMotion& write);
    static void moveHolds(OdeObjects& objects, const OdeActor& actor, const Pose& motion);
    static void addTorque(const OdeObjects& objects, const JointTorque& write);

    std::vector<JointTorque> m_torques;
    std::vector<BodyForce> m_forces;
    std::vector<ActorMotion> m_motions;
    std::vector<std::uint32_t> m_moved; ///< actors
};

} // namespace trundle
