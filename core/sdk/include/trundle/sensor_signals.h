// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The signals of the sensors that come with Trundle, since 1.6. `time` is when the reading was measured; -1 before the first one.

#include <array>
#include <cstdint>
#include <vector>

#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

struct RangeSensorSignals {
    static constexpr const char* kKind = "RangeSensor";
    OutputSlot<double> range, voltage, time;
    TruthSlot<double> trueRange;
    TruthSlot<std::int64_t> object;

    template <class D> static void describe(D& d) {
        using S = RangeSensorSignals;
        d.output("range", &S::range, "m", "Distance of the nearest echo; MaxRange where there is none.");
        d.output("voltage", &S::voltage, "V", "Output of an infrared sensor at this range, by its VoltageCurve.");
        d.output("time", &S::time, "s", "When it was measured.");
        d.truth("trueRange", &S::trueRange, "m",
                "Distance of the nearest surface in its cone, at the end of the tick it was measured.");
        d.truth("object", &S::object, "", "Number of the object with that surface; 0: none. RobotPorts::objectName gives its name.");
    }
};

struct LidarSignals {
    static constexpr const char* kKind = "Lidar";
    OutputSlot<std::vector<double>> ranges, intensities;
    OutputSlot<double> time;
    TruthSlot<std::vector<double>> objects;

    template <class D> static void describe(D& d) {
        using S = LidarSignals;
        d.output("ranges", &S::ranges, "m",
                 "Layer by layer from below, each from -FieldOfView/2 counter-clockwise; MaxRange where nothing is hit.",
                 {"Beams", "Layers"});
        d.output("time", &S::time, "s", "When they were measured; with a SweepTime, the last of them.");
        d.output("intensities", &S::intensities, "",
                 "Share of light that each returns, in the order of `ranges`; zeros unless Intensity is set.",
                 {"Beams", "Layers"});
        d.truth("objects", &S::objects, "",
                "Numbers of the objects that the beams hit, in the order of `ranges`, 0 for none; zeros unless Objects is set.",
                {"Beams", "Layers"});
    }
};

struct ImuSignals {
    static constexpr const char* kKind = "Imu";
    OutputSlot<std::array<double, 3>> angularVelocity, acceleration;
    OutputSlot<std::array<double, 4>> orientation;
    OutputSlot<double> time;

    template <class D> static void describe(D& d) {
        using S = ImuSignals;
        d.output("angularVelocity", &S::angularVelocity, "rad/s", "About its own x, y, z.");
        d.output("acceleration", &S::acceleration, "m/s^2", "Specific force along its own x, y, z: at rest 9.81 upwards.");
        d.output("orientation", &S::orientation, "", "In the world, quaternion w, x, y, z; zeros unless Orientation is set.");
        d.output("time", &S::time, "s", "When they were measured.");
    }
};

struct CompassSignals {
    static constexpr const char* kKind = "Compass";
    OutputSlot<double> heading, time;

    template <class D> static void describe(D& d) {
        using S = CompassSignals;
        d.output("heading", &S::heading, "rad",
                 "Of its x axis over the floor, counter-clockwise from x of the world, from -pi to pi.");
        d.output("time", &S::time, "s", "When it was measured.");
    }
};

struct GpsSignals {
    static constexpr const char* kKind = "Gps";
    OutputSlot<std::array<double, 3>> position, velocity;
    OutputSlot<double> time;

    template <class D> static void describe(D& d) {
        using S = GpsSignals;
        d.output("position", &S::position, "m", "Of its antenna in the world: x, y, z.");
        d.output("velocity", &S::velocity, "m/s", "Of its antenna in the world: x, y, z.");
        d.output("time", &S::time, "s", "When they were measured.");
    }
};

/// Since 1.7.
struct GroundSensorSignals {
    static constexpr const char* kKind = "GroundSensor";
    OutputSlot<double> reflectance, time;
    TruthSlot<double> trueReflectance;

    template <class D> static void describe(D& d) {
        using S = GroundSensorSignals;
        d.output("reflectance", &S::reflectance, "", "Share of light that the floor returns, from 0 (black) to 1 (white).");
        d.output("time", &S::time, "s", "When it was measured.");
        d.truth("trueReflectance", &S::trueReflectance, "", "The same without errors.");
    }
};

/// Since 1.7.
struct LightSensorSignals {
    static constexpr const char* kKind = "LightSensor";
    OutputSlot<double> illuminance, time;
    TruthSlot<double> trueIlluminance;

    template <class D> static void describe(D& d) {
        using S = LightSensorSignals;
        d.output("illuminance", &S::illuminance, "lx", "From the lamps, the sun and the sky in front of it.");
        d.output("time", &S::time, "s", "When it was measured.");
        d.truth("trueIlluminance", &S::trueIlluminance, "lx", "The same without errors and limits.");
    }
};

/// Since 1.11.
struct ForceSensorSignals {
    static constexpr const char* kKind = "ForceSensor";
    OutputSlot<std::array<double, 3>> force, torque;
    OutputSlot<double> time;
    TruthSlot<std::array<double, 3>> trueForce, trueTorque;

    template <class D> static void describe(D& d) {
        using S = ForceSensorSignals;
        d.output("force", &S::force, "N", "Of the joint's parent on its child, in the sensor's frame.");
        d.output("torque", &S::torque, "N m", "The same, about the sensor's place.");
        d.output("time", &S::time, "s", "When they were measured: the end of the tick over which they acted.");
        d.truth("trueForce", &S::trueForce, "N", "The same without errors and limits.");
        d.truth("trueTorque", &S::trueTorque, "N m", "The same without errors and limits.");
    }
};

} // namespace sdk1
} // namespace trundle
