/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI for cameras, since 1.2. Included by abi.h. */
#ifndef TRUNDLE_ABI_CAMERA_H
#define TRUNDLE_ABI_CAMERA_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A camera image. Rows from the top; the pointers are valid until the same camera renders its next image. */
typedef struct TrundlePicture {
    uint32_t size; /* set by the caller; no more bytes are written */
    uint32_t width, height, reserved;
    double time;             /* simulated time of the image, s */
    const uint8_t* pixels;   /* width * height * 3, RGB */
    const float* depth;      /* m along the camera's axis, infinite without an object; NULL in Mode color and grey */
    const uint32_t* objects; /* 0: none, else an argument of objectName; NULL except in Mode segmentation */
} TrundlePicture;

/* The cameras of a controller's robot. Calls return 0 on success; otherwise lastError gives the reason. */
typedef struct TrundleCameras {
    uint32_t size, reserved;
    void* context;
    int32_t (*capture)(void* context, const char* camera, TrundlePicture* picture); /* renders and waits for the result */
    int32_t (*save)(void* context, const char* camera, const char* fileName);       /* .png or .jpg, in the log folder */
    const char* (*objectName)(void* context, uint32_t object);                      /* NULL: no such object */
    const char* (*lastError)(void* context);
} TrundleCameras;

#ifdef __cplusplus
}
#endif
#endif
