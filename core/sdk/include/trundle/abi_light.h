/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI through which devices see light and what returns it. Included by light.h. */
#ifndef TRUNDLE_ABI_LIGHT_H
#define TRUNDLE_ABI_LIGHT_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { TRUNDLE_SUN = 1, TRUNDLE_LAMP = 2, TRUNDLE_SKY = 3, TRUNDLE_GROUND = 4 };

/* A light of the experiment. On a surface with the unit normal n it adds, unless something is in between: the sun light * max(0, n . way);
 * a lamp the same divided by the square of its distance; the sky light * (1 + n.z) / 2; the ground light * (1 - n.z) / 2. */
typedef struct TrundleLight {
    double way[3];        /* world frame: of the sun a unit vector towards it, of a lamp its position, m */
    double light;         /* Rec. 709 luminance, linear: 1 on a white surface shows white */
    uint32_t type, shadows;
} TrundleLight;

/* How a lamp shines. Along a way at the angle a from its axis its light is light * cos(a)^exponent, and nothing behind it; with an
 * exponent of 0 it is the same all around. */
typedef struct TrundleBeam {
    double axis[3];  /* unit vector: in the world frame, of `emitBeam` in that of the body */
    double exponent;
    double radius;   /* of its lens, m: what is in there does not hide it */
} TrundleBeam;

/* For devices in act and sense, with the poses after the last step; uses the context of TrundleServices. World frame, m. Light is
 * linear: the square of a colour in the text or of a picture. */
typedef struct TrundleServicesLight {
    uint32_t size, reserved;
    /* Share of the light that a geom returns at a point of its surface, 0..1: Rec. 709 luminance of the picture of its material there,
     * else of its colour. `normal` points outwards. 0: found. */
    int32_t (*reflectance)(void* context, uint32_t geom, const double point[3], const double normal[3], double* reflectance);
    /* All lights; returns their number. */
    uint32_t (*lights)(void* context, TrundleLight* out, uint32_t capacity);
    /* Since 1.7. The device is a lamp from now on, at a point of a body (m, in its frame), with shadows; 0: it is dark. */
    void (*emit)(void* context, uint32_t body, const double point[3], double light);
    /* Since 1.8. The same with a direction; NULL: all around. */
    void (*emitBeam)(void* context, uint32_t body, const double point[3], double light, const TrundleBeam* beam);
    /* Since 1.8. How they shine, in the order of `lights`; returns their number. Sun, sky and ground shine all around. */
    uint32_t (*beams)(void* context, TrundleBeam* out, uint32_t capacity);
} TrundleServicesLight;

#ifdef __cplusplus
}
#endif
#endif
