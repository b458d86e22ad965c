/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the border that cameras use, since 1.2. Included by abi.h. */
#ifndef TRUNDLE_ABI_CAMERA_H
#define TRUNDLE_ABI_CAMERA_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What a camera took. Rows from the top; the pointers stay good until the same camera takes its next picture. */
typedef struct TrundlePicture {
    uint32_t size; /* set by the asker; no more is written */
    uint32_t width, height, reserved;
    double time;             /* simulated s that it shows */
    const uint8_t* pixels;   /* width * height * 3: red, green, blue */
    const float* depth;      /* m along the camera's axis, infinite where there is nothing; NULL in Mode color and grey */
    const uint32_t* objects; /* 0 where there is nothing, else for objectName; NULL but in Mode segmentation */
} TrundlePicture;

/* The cameras of a controller's robot. Where a call gives anything but 0, lastError says why and the controller may go on. */
typedef struct TrundleCameras {
    uint32_t size, reserved;
    void* context;
    int32_t (*capture)(void* context, const char* camera, TrundlePicture* picture); /* draws, and waits for it */
    int32_t (*save)(void* context, const char* camera, const char* fileName);       /* .png or .jpg, in the log folder */
    const char* (*objectName)(void* context, uint32_t object);                      /* NULL: no such object */
    const char* (*lastError)(void* context);
} TrundleCameras;

#ifdef __cplusplus
}
#endif
#endif
