#pragma once
// The rows that act along the free axes of joints: motors, springs with dampers, friction, stops. Each has rows of its own beside the
// joint, so that all of them can act at once. Also measures joints.

#include <memory>
#include <span>
#include <vector>

#include "world/ode/joints/axis_motor.h"
#include "world/ode/joints/joint_inertia.h"
#include "world/ode/objects/ode_records.h"
#include "world/spring_row.h"

namespace trundle {

class JointRows {
public:
    /// The arrays belong to the engine and outlive this.
    JointRows(const std::vector<OdeBody>& bodies, std::vector<OdeJoint>& joints)
        : m_bodies(bodies), m_joints(joints), m_inertias(bodies, joints) {}

    /// Adds the rows of a joint that is already in the array; axes in the world.
    void add(std::uint32_t joint, const JointSpec& spec, const Vec3& axis, const Vec3& axis2);
    /// This joint and all later ones, which are gone.
    void forget(std::uint32_t joint);
    void setMotor(std::uint32_t joint, const MotorConstraint& motor);
    /// Prepares all rows for a step with these contacts. `errorReduction`: of stops, and of a suspension at the end of its travel.
    void update(double h, std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms, double errorReduction);
    /// Position, rate and effort after a step.
    void measure(OdeJoint& joint, double h) const;
    [[nodiscard]] JointInertias& inertias() { return m_inertias; }
    /// From the parent's anchor to the child's, world.
    [[nodiscard]] Vec3 anchorGap(const OdeJoint& joint) const;

private:
    void addStop(OdeJoint& joint, const JointSpec& spec, const Vec3& axis, const Vec3& axis2) const;
    void updateInertia(std::uint32_t index);
    void findTouches(std::span<const OdeContact> contacts, std::span<const OdeGeom> geoms);
    [[nodiscard]] bool isHeld(const OdeJoint& joint, double push) const;
    void updateStop(OdeJoint& joint, double h, double errorReduction) const;
    void updateSpring(OdeJoint& joint, double h) const;
    void updateSuspension(OdeJoint& joint, double h, double errorReduction) const;
    [[nodiscard]] Vec3 anchorSpeed(const OdeJoint& joint) const;
    [[nodiscard]] Vec3 carried(const OdeJoint& joint, const Vec3& axis) const;

    // motors (motor_rows.cpp)
    void updateMotor(OdeJoint& joint, double h);
    void updateServo(OdeJoint& joint, double h);
    void writeMotor(OdeJoint& joint, double rate, double cfm, double limit);
    void updateLosses(OdeJoint& joint, double h);
    dJointFeedback* makeFeedback();
    [[nodiscard]] double effortOf(const OdeJoint& joint) const;
    [[nodiscard]] double motorDamping(const OdeJoint& joint) const;

    /// A contact with something that does not move.
    struct Touch {
        std::uint32_t next; ///< of the same body
        Vec3 position, normal;
    };

    const std::vector<OdeBody>& m_bodies;
    std::vector<OdeJoint>& m_joints;
    JointInertias m_inertias;
    std::vector<std::uint32_t> m_updated, m_driven; ///< joints whose rows change from tick to tick
    std::vector<std::unique_ptr<dJointFeedback>> m_feedbacks;
    std::vector<bool> m_touched;             ///< by body, where something is driven
    std::vector<std::uint32_t> m_firstTouch; ///< by body, where something has a spring
    std::vector<Touch> m_touches;
    std::uint32_t m_ticks = 0;
};

} // namespace trundle
