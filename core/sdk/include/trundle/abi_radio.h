/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI for radios, since 1.2. Included by abi.h. Powers in dBm. */
#ifndef TRUNDLE_ABI_RADIO_H
#define TRUNDLE_ABI_RADIO_H

#include <stdint.h>

#define TRUNDLE_MOST_PAYLOAD 116u /* bytes of a packet */

#ifdef __cplusplus
extern "C" {
#endif

typedef struct TrundlePacket {
    uint32_t size, count; /* of this struct; of `bytes` */
    double time;          /* s, of the last bit, by the receiver's clock */
    double rssi;
    uint32_t lqi, from, to, sequence;
    uint8_t bytes[128];
} TrundlePacket;

/* For controllers; uses the context of TrundleRobot. */
typedef struct TrundleRobotRadio {
    uint32_t size, reserved;
    int32_t (*find)(void* context, const char* component, uint32_t* radio); /* 0: found; otherwise the host reports the failure */
    uint32_t (*address)(void* context, uint32_t radio);
    /* Queues a packet; `to` 0xffff: broadcast. 0: success. */
    int32_t (*send)(void* context, uint32_t radio, const uint8_t* bytes, uint32_t count, uint32_t to, double power);
    /* Takes the oldest packet from the queue. 0: there is none. */
    int32_t (*receive)(void* context, uint32_t radio, TrundlePacket* packet);
} TrundleRobotRadio;

typedef struct TrundleRadioSettings {
    uint32_t size, body;
    double position[3], quaternion[4]; /* of the antenna in the body's frame; w x y z */
    const char* antenna;               /* an AntennaPattern or an antenna model */
    double maxOutputPower, minReceivePower, maxReceivePower, rssiStep, bitRate, supply, receiveCurrent; /* dB, bit/s, V, A */
    uint32_t bufferLimit, channel, address, reserved;
    const double* powerLevels;
    const double* transmitCurrents; /* A; one value, or one per level */
    uint32_t powerLevelCount, transmitCurrentCount;
} TrundleRadioSettings;

/* For devices in setup; uses the context of TrundleMount. */
typedef struct TrundleMountRadio {
    uint32_t size, reserved;
    int32_t (*open)(void* context, const TrundleRadioSettings* settings, uint32_t* radio); /* 0: success, as for joint */
} TrundleMountRadio;

typedef struct TrundleRadioState {
    uint32_t size, address, pending, queued;
    uint64_t sent, received, dropped, failed;
    double rssi, energy; /* of the last packet received; J */
    uint32_t lqi, reserved;
} TrundleRadioState;

/* For devices in act and sense; uses the context of TrundleServices. */
typedef struct TrundleServicesRadio {
    uint32_t size, reserved;
    void (*state)(void* context, uint32_t radio, TrundleRadioState* state);
} TrundleServicesRadio;

#ifdef __cplusplus
}
#endif
#endif
