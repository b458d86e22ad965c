/* SPDX-License-Identifier: BSD-2-Clause
 * The C ABI between Trundle and a module: only fixed-width integers, doubles, C strings and function tables cross it.
 * A module exports one symbol, trundle_module. Module authors include controller.h or device.h instead of this file.
 * Within one major version structs only grow at their end; a `size` field gives the size that the other side was built with. */
#ifndef TRUNDLE_ABI_H
#define TRUNDLE_ABI_H

#include <stdint.h>

#include <trundle/abi_camera.h>
#include <trundle/abi_radio.h>
#include <trundle/abi_supply.h>
#include <trundle/abi_world.h>

#define TRUNDLE_MAGIC 0x444e5254u /* "TRND" */
#define TRUNDLE_ABI_MAJOR 1u
#define TRUNDLE_ABI_MINOR 10u
#define TRUNDLE_SDK_VERSION "1.13.0"

#ifdef __cplusplus
extern "C" {
#endif

/* clang-format off */ /* Type of a field. NUMBER, INTEGER and BOOLEAN use `numbers`, the others `texts`. */
enum {
    TRUNDLE_NUMBER = 1, TRUNDLE_INTEGER = 2, TRUNDLE_BOOLEAN = 3,
    TRUNDLE_CHOICE = 4,    /* one of `choices` */
    TRUNDLE_TEXT = 5,
    TRUNDLE_FILE = 6,      /* `choices`: the accepted extensions, "png|jpg" */
    TRUNDLE_REFERENCE = 7  /* `choices`: the accepted kinds or roles, "RotaryMotor" or "Hinge|Slider" or "Geom" */
};

typedef struct TrundleValue {
    const double* numbers; /* SI units: degrees in the text are converted to radians */
    const char* const* texts;
    uint32_t count;
} TrundleValue;

enum {
    TRUNDLE_REQUIRED = 1, /* must be in the text */
    TRUNDLE_OPTIONAL = 2, /* no default: a missing value means "not given" */
    TRUNDLE_LIVE = 4,     /* may change during a run, with immediate effect */
    TRUNDLE_MIN_EXCLUSIVE = 8, TRUNDLE_MAX_EXCLUSIVE = 16
};

typedef struct TrundleField {
    const char* name;
    const char* unit;    /* unit of a plain number in the text: "m", "deg", "" */
    const char* help;    /* one line */
    const char* choices; /* separated by '|' */
    double scale;        /* factor from text unit to SI: pi/180 for "deg" */
    double minimum, maximum; /* in text units; -inf, +inf: none */
    uint32_t type, minCount, maxCount; /* elements: 1..1 for a scalar, 3..3 for a vector */
    uint32_t flags;
    TrundleValue defaultValue; /* count 0: none */
} TrundleField;

enum { TRUNDLE_REAL_SIGNAL = 1, TRUNDLE_INTEGER_SIGNAL = 2, TRUNDLE_BOOLEAN_SIGNAL = 3 };
/* TRUTH: ground truth, which a real robot cannot measure; controllers read it only through groundTruth ports. */
enum { TRUNDLE_OUTPUT = 1, TRUNDLE_COMMAND = 2, TRUNDLE_TRUTH = 3 };

/* A signal of a device, or since 1.3 of a controller (only TRUNDLE_OUTPUT): `count` slots of 8-byte doubles in its robot's image.
 * Integers and booleans are stored as doubles. Since 1.5 countFields names up to two integer fields whose values multiply the
 * count: 1 + the index of the first in bits 0-15, of the second in bits 16-31; 0: none. */
typedef struct TrundleSignal {
    const char* name;
    const char* unit; /* SI: "m/s", "rad" */
    const char* help;
    uint32_t type, count, direction, countFields;
} TrundleSignal;

/* ---- controllers ---- */
enum { TRUNDLE_INFO = 1, TRUNDLE_WARNING = 2, TRUNDLE_ERROR = 3 };
/* Access of a controller to its robot. Pointers are valid until the controller is destroyed. */
typedef struct TrundleRobot {
    uint32_t size, reserved;
    void* context;
    const char* name; /* the robot's name */
    double tick;      /* s */
    /* First slot of a signal of a component, or NULL; the host then reports the available names. */
    double* (*bind)(void* context, const char* kind, const char* component, const char* signal);
    double (*time)(void* context); /* simulated time of the last completed tick, s */
    void (*print)(void* context, int32_t severity, const char* text);
    void (*fail)(void* context, const char* text); /* the controller cannot continue */
    uint64_t (*random)(void* context);             /* a function of (seed, robot, tick, index of the call in this tick) */
    int32_t (*openLog)(void* context, const char* fileName); /* in the log folder; -1: refused */
    void (*writeLog)(void* context, int32_t log, const char* bytes, uint64_t count);
    /* Query that reports no failure; an empty signal or component queries the component or the robot itself. 0: it exists. */
    int32_t (*signalInfo)(void* context, const char* component, const char* signal, uint32_t* count, uint32_t* direction);
    const TrundleCameras* cameras; /* since 1.2 */
    const TrundleRobotRadio* radio; /* since 1.2 */
    /* Since 1.3. First slot and slot count of a signal of the controller's kind; NULL: unknown, reported by the host. */
    double* (*publish)(void* context, const char* signal, uint32_t* count);
    /* Since 1.3. Ends the run normally after the current tick; the first call of a run counts. */
    void (*finish)(void* context, const char* reason);
} TrundleRobot;

/* ---- devices ---- */
typedef struct TrundleMount {
    uint32_t size, reserved;
    void* context;
    const char* path; /* "robot0/leftMotor" */
    double tick;      /* s */
    double* (*signal)(void* context, const char* name);                 /* own slot */
    int32_t (*joint)(void* context, const char* name, uint32_t* joint); /* 0: found; otherwise the host reports the failure */
    int32_t (*body)(void* context, const char* name, uint32_t* body);
    int32_t (*geom)(void* context, const char* path, uint32_t* geom);   /* "body.geom" */
    /* A slot of another device of the robot. This device then acts before the other one and senses after it. */
    double* (*peerSignal)(void* context, const char* kind, const char* device, const char* signal);
    /* The resolved value of another device's field, SI units. 0: found. */
    int32_t (*peerNumber)(void* context, const char* device, const char* field, double* value);
    const char* (*peerText)(void* context, const char* device, const char* field);
    void (*fail)(void* context, const char* text);
    /* Adds kg m^2 to the joint's child about the joint's axis (a geared rotor that turns with it). 0: success. */
    int32_t (*addAxialInertia)(void* context, uint32_t joint, double inertia);
    void (*print)(void* context, int32_t severity, const char* text);
    const TrundleMountRadio* radio; /* since 1.2 */
    /* Since 1.7. The device becomes the supply of its robot and senses after all others of it. -1: there is another one. */
    int32_t (*provideSupply)(void* context, double nominal, double voltage);
    int32_t (*measureJoint)(void* context, const char* name, uint32_t* joint); /* since 1.8; a joint of any kind. 0: its wrench is measured */
    /* Since 1.10. A rotor (kg m^2) on the joint's parent that turns `ratio` times as far against it as the joint's child. 0: success. */
    int32_t (*addRotor)(void* context, uint32_t joint, double inertia, double ratio);
} TrundleMount;
/* Access of a device to the world in act and sense. Actuation is ignored outside act. */
typedef struct TrundleServices {
    uint32_t size, reserved;
    void* context;
    double tick; /* s */
    double time; /* s; of the last completed tick in act, of the tick just stepped in sense */
    /* actuation */
    void (*motorRow)(void* context, uint32_t joint, double rate, double softness, double limit);
    void (*jointTorque)(void* context, uint32_t joint, double torque);
    void (*bodyForce)(void* context, uint32_t body, const double force[3], const double point[3]);
    void (*surfaceVelocity)(void* context, uint32_t geom, const double velocity[3]); /* m/s in the geom's frame */
    /* joints: rad and rad/s (m and m/s for a slider); the angle is unwrapped */
    double (*jointPosition)(void* context, uint32_t joint);
    double (*jointRate)(void* context, uint32_t joint);
    double (*jointMotorEffort)(void* context, uint32_t joint); /* of the motor in the last step, N m or N */
    void (*bodyState)(void* context, uint32_t body, TrundleBodyState* state);
    uint32_t (*contacts)(void* context, uint32_t geom, TrundleContact* out, uint32_t capacity); /* returns their number */
    /* Nearest hit along a unit direction within `range`; geoms of the device's robot are ignored unless `own`. 0: none. */
    int32_t (*ray)(void* context, const double origin[3], const double direction[3], double range, int32_t own, TrundleHit* hit);
    uint64_t (*random)(void* context, uint64_t index); /* a function of (seed, device path, tick, index) */
    void (*jointAnchor)(void* context, uint32_t joint, double anchor[3], double axis[3]); /* world frame, fixed to the parent */
    void (*print)(void* context, int32_t severity, const char* text); /* to the console, with the device's path */
    const TrundleServicesRadio* radio; /* since 1.2 */
    /* Since 1.4. Keeps the joint at `rate` with an effort from -limit to limit - damping * |joint rate| along its motion. */
    void (*servoRow)(void* context, uint32_t joint, double rate, double limit, double damping);
    const TrundleServicesRays* rays; /* since 1.5 */
    const struct TrundleServicesLight* light; /* since 1.6; in abi_light.h */
    const TrundleServicesSupply* supply;      /* since 1.7 */
    const struct TrundleServicesJoints* joints; /* since 1.8; in abi_joint.h */
    const struct TrundleServicesLatch* latch; /* since 1.9; in abi_latch.h */
} TrundleServices;

/* ---- kinds and the module ---- */
enum { TRUNDLE_CONTROLLER = 1, TRUNDLE_DEVICE = 2 };
enum { TRUNDLE_INDEPENDENT = 1 }; /* since 1.10: uses nothing that robots share, so that it may be called beside those of other robots */
/* Fields of which exactly one must be given; each is TRUNDLE_OPTIONAL. */
typedef struct TrundleAlternatives {
    const char* names;  /* "SpeedConstant|BackEmfConstant" */
    const char* likely; /* if all are missing, the value of this field is suggested for the last one; "": none */
} TrundleAlternatives;

typedef struct TrundleKind { /* every function returns 0 on success; after any other value lastError gives the reason */
    uint32_t size, role;
    const char *name, *help;
    const TrundleField* fields;
    const TrundleSignal* signals; /* devices; controllers since 1.3 */
    uint32_t fieldCount, signalCount;
    void* (*create)(void);
    void (*destroy)(void* instance);
    int32_t (*set)(void* instance, uint32_t field, const TrundleValue* value);
    const char* (*lastError)(void* instance); /* also with instance NULL: why create failed */
    /* controllers */
    int32_t (*setupController)(void* instance, const TrundleRobot* robot);
    int32_t (*update)(void* instance, double secondsSinceLastUpdate);
    /* devices; act or sense may be NULL */
    int32_t (*setupDevice)(void* instance, const TrundleMount* mount);
    int32_t (*act)(void* instance, const TrundleServices* services);
    int32_t (*sense)(void* instance, const TrundleServices* services);
    const TrundleAlternatives* alternatives; /* since 1.1 */
    uint32_t alternativesCount, traits; /* traits: bits, since 1.10 */
    /* Controllers, since 1.9; NULL: no state. saveState calls `write` with it or not at all; loadState follows setupController. */
    int32_t (*saveState)(void* instance, void (*write)(void* to, const char* bytes, uint64_t count), void* to);
    int32_t (*loadState)(void* instance, const char* bytes, uint64_t count);
} TrundleKind;
typedef struct TrundleModule {
    uint32_t magic, size, abiMajor, abiMinor;
    const char* sdkVersion;
    const TrundleKind* const* kinds;
    uint32_t kindCount, reserved;
} TrundleModule;
/* The one exported symbol: `const TrundleModule* trundle_module(void)`. */
typedef const TrundleModule* (*TrundleModuleEntry)(void);
#define TRUNDLE_ENTRY_SYMBOL "trundle_module"
#ifdef __cplusplus
}
#endif
#endif
