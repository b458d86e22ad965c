/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI through which devices hold other bodies, since 1.9. Included by latch.h. */
#ifndef TRUNDLE_ABI_LATCH_H
#define TRUNDLE_ABI_LATCH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Uses the context of TrundleServices. A device has one latch. */
typedef struct TrundleServicesLatch {
    uint32_t size, reserved;
    /* In act: holds the body of a geom, or the scenery that it is part of, rigidly to a body of the device's robot, as they are.
     * 0: success; -1: there is no such geom or body, or the geom is of the same body. */
    int32_t (*hold)(void* context, uint32_t body, uint32_t geom);
    void (*release)(void* context); /* in act */
    /* Force (N) and torque (N m, about its centre of mass) on what is held in the last step, world frame. 0: it holds. */
    int32_t (*held)(void* context, double force[3], double torque[3]);
} TrundleServicesLatch;

#ifdef __cplusplus
}
#endif
#endif
