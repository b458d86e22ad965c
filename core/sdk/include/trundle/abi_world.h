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

/* Beams from one point: `layers` rings of `count` beams. The beam k of a ring has the bearing firstBearing + k * bearingStep about the
 * pose's z axis, counter-clockwise from its x axis, and the ring's elevation above its x-y plane. */
typedef struct TrundleFan {
    double position[3], quaternion[4]; /* in the world, m; w x y z */
    double range;                      /* m */
    double firstBearing, bearingStep;  /* rad */
    const double* elevations;          /* rad, one for each layer, from -pi/2 to pi/2 */
    uint32_t count, layers;            /* at least 1 */
    int32_t own;                       /* 0: geoms of the device's robot are ignored */
    uint32_t reserved;
} TrundleFan;

typedef struct TrundleRay {
    double origin[3], direction[3]; /* world frame, m; a unit vector */
    double range;                   /* m */
} TrundleRay;

/* What a sensor measures of a geom. The caller sets `size`. Texts are valid as long as the world exists. */
typedef struct TrundleGeomInfo {
    uint32_t size, reserved;
    const char* path;          /* "robot0/chassis/hull", "box/block": ground truth, which no sensor measures */
    const char* material;      /* its name; "default": the geom has none */
    double colour[3];          /* red, green, blue as in the text, 0..1 */
    double reflectance;        /* share of light that the material returns, 0..1: Rec. 709 luminance of colour and texture */
    double opacity, shininess; /* 0..1 */
    uint32_t object, reserved2; /* since 1.9: its number, as in pictures of cameras with Mode=segmentation; ground truth */
} TrundleGeomInfo;

/* For devices in act and sense, with the poses after the last step; uses the context of TrundleServices. Results of castFan are layer
 * by layer, of castRays in the order of the rays: the distance, or the range where nothing is hit; the geom, or 0xffffffff; the normal,
 * against the beam, or zeros. `geoms` and `normals` (three numbers each) may be NULL. 0: success; otherwise an invalid value was given,
 * no result is written, and the host reports it. */
typedef struct TrundleServicesRays {
    uint32_t size, reserved;
    int32_t (*castFan)(void* context, const TrundleFan* fan, double* distances, uint32_t* geoms, double* normals);
    int32_t (*castRays)(void* context, const TrundleRay* rays, uint32_t count, int32_t own, double* distances, uint32_t* geoms,
                        double* normals);
    int32_t (*geomInfo)(void* context, uint32_t geom, TrundleGeomInfo* info); /* 0: found */
} TrundleServicesRays;

#ifdef __cplusplus
}
#endif
#endif
