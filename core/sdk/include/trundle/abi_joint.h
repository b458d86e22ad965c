/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI through which devices drive and measure joints, since 1.8. Included by joints.h. */
#ifndef TRUNDLE_ABI_JOINT_H
#define TRUNDLE_ABI_JOINT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What drives a joint until it is replaced. Units: rad/s and N m, of a slider m/s and N. The caller sets `size`. */
typedef struct TrundleJointDrive {
    uint32_t size, reserved;
    double rate, softness, limit, damping;  /* as of motorRow; with a damping, as of servoRow */
    double dryFriction;                     /* against the motion, and up to it against whatever would start one */
    double viscousFriction;                 /* times the joint's rate, against the motion */
} TrundleJointDrive;

/* Uses the context of TrundleServices. */
typedef struct TrundleServicesJoints {
    uint32_t size, reserved;
    void (*drive)(void* context, uint32_t joint, const TrundleJointDrive* drive); /* in act */
    /* What the friction of the drive did in the last step, N m or N, positive along the positive motion. */
    double (*frictionEffort)(void* context, uint32_t joint);
    /* Force (N) and torque (N m, about the anchor) of the joint's parent on its child in the last step, world frame, of a joint
     * from TrundleMount::measureJoint. 0: success. */
    int32_t (*wrench)(void* context, uint32_t joint, double force[3], double torque[3]);
} TrundleServicesJoints;

#ifdef __cplusplus
}
#endif
#endif
