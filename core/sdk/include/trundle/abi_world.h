/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI through which devices read the world. Included by abi.h. */
#ifndef TRUNDLE_ABI_WORLD_H
#define TRUNDLE_ABI_WORLD_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TrundleContact {
    double position[3]; /* world frame, m */
    double normal[3];   /* world frame, towards the queried geom */
    double depth;       /* m */
    double force;       /* N along the normal, of the last step */
    uint32_t other;     /* geom; 0xffffffff: unknown */
    uint32_t reserved;
} TrundleContact;

typedef struct TrundleHit {
    double distance; /* m */
    double normal[3];
    uint32_t geom, reserved;
} TrundleHit;

typedef struct TrundleBodyState {
    double position[3];   /* of the body's frame in the world, m */
    double quaternion[4]; /* w x y z */
    double linear[3];     /* m/s, of the body frame's origin, world frame */
    double angular[3];    /* rad/s, world frame */
} TrundleBodyState;

#ifdef __cplusplus
}
#endif
#endif
