// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What drives a joint, and what acts across it, for devices. Since 1.10.

#include <cstddef>

#include <trundle/abi.h>
#include <trundle/abi_joint.h>
#include <trundle/geometry.h>

namespace trundle {
inline namespace sdk1 {

/// A drive of a joint: motor, or with a damping servo, and its friction. Units: rad/s and N m, of a slider m/s and N.
struct JointDrive {
    double rate = 0;
    double softness = 0; ///< of a motor: its effort is (rate - new rate) / softness
    double limit = 0;    ///< of the effort
    double damping = 0;  ///< of a servo: along the motion its effort is at most limit - damping * |joint rate|
    double dryFriction = 0;
    double viscousFriction = 0; ///< per rate
};

/// Of a joint's parent on its child, world frame: N, and N m about the joint's anchor.
struct Wrench {
    Vec3 force, torque;
};

namespace detail {

/// nullptr: the program is older.
inline const TrundleServicesJoints* jointsOf(const TrundleServices& services) {
    return services.size >= offsetof(TrundleServices, joints) + sizeof services.joints ? services.joints : nullptr;
}

inline void driveJoint(const TrundleServices& services, std::uint32_t joint, const JointDrive& d) {
    if (const TrundleServicesJoints* table = jointsOf(services)) {
        const TrundleJointDrive drive{sizeof drive, 0, d.rate, d.softness, d.limit, d.damping, d.dryFriction, d.viscousFriction};
        table->drive(services.context, joint, &drive);
    } else if (d.damping > 0) services.servoRow(services.context, joint, d.rate, d.limit, d.damping);
    else services.motorRow(services.context, joint, d.rate, d.softness, d.limit);
}

inline double frictionEffort(const TrundleServices& services, std::uint32_t joint) {
    const TrundleServicesJoints* table = jointsOf(services);
    return table ? table->frictionEffort(services.context, joint) : 0;
}

inline bool wrench(const TrundleServices& services, std::uint32_t joint, Wrench& out) {
    const TrundleServicesJoints* table = jointsOf(services);
    return table && table->wrench(services.context, joint, out.force.data(), out.torque.data()) == 0;
}

} // namespace detail
} // namespace sdk1
} // namespace trundle
