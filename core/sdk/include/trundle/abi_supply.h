/* SPDX-License-Identifier: BSD-2-Clause
 * The part of the ABI through which devices draw electric power, since 1.7. Included by abi.h. */
#ifndef TRUNDLE_ABI_SUPPLY_H
#define TRUNDLE_ABI_SUPPLY_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* What the devices of a robot drew in the last tick. */
typedef struct TrundleLoad {
    double regulated;   /* W, of loads that take the same power at any voltage */
    double resistive;   /* W, of loads whose current grows with the voltage */
    double conductance; /* A/V, by which it grows */
} TrundleLoad;

/* What a device offers to what touches one of its geoms. */
typedef struct TrundleOffer {
    double volts;   /* at most */
    double amperes; /* at most; 0: nothing */
} TrundleOffer;

typedef struct TrundleTaken {
    double watts, amperes;
    uint32_t takers, reserved;
} TrundleTaken;

/* For devices in act and sense; uses the context of TrundleServices. */
typedef struct TrundleServicesSupply {
    uint32_t size, reserved;
    /* The voltage of this tick, V; 0: it is empty. -1: the robot has no supply, and its devices have all that they need. */
    int32_t (*voltage)(void* context, double* voltage, double* nominal);
    /* In sense: what the device drew in this tick, W, negative what it gave back; with a conductance above 0, a resistive load. */
    void (*draw)(void* context, double watts, double conductance);
    /* For the device that is the supply, in sense: what all others drew. */
    void (*load)(void* context, TrundleLoad* load);
    void (*setVoltage)(void* context, double voltage); /* for the device that is the supply, in sense: of the next tick */
    /* Since 1.8. In act: what touches the geom can take power from the device, from all of its geoms together at most `amperes`. */
    void (*offer)(void* context, uint32_t geom, double volts, double amperes);
    /* Since 1.8. For the device that is the supply, in sense: what the geom offers to each that takes from it. */
    void (*offered)(void* context, uint32_t geom, TrundleOffer* offer);
    /* Since 1.8. For the device that is the supply, in sense: what it took from the geom in this tick. */
    void (*take)(void* context, uint32_t geom, double volts, double amperes);
    /* Since 1.8. For a device that offers power: what was taken from it in the tick before. */
    void (*taken)(void* context, TrundleTaken* taken);
} TrundleServicesSupply;

#ifdef __cplusplus
}
#endif
#endif
