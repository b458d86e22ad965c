// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The signals of the devices that come with Trundle: the one table from which the device and the port of a controller are made.

#include <array>
#include <cstdint>

#include <trundle/equipment_signals.h>
#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// A base with two driven wheels.
struct DifferentialDriveSignals {
    static constexpr const char* kKind = "DifferentialDrive";
    CommandSlot<double> linearVelocity, angularVelocity, linearAmount, angularAmount;
    CommandSlot<std::int64_t> sequence;
    TruthSlot<std::array<double, 3>> pose;
    OutputSlot<std::array<double, 3>> odometry;
    OutputSlot<bool> done, busy;
    OutputSlot<std::int64_t> finished;
    TruthSlot<std::array<double, 2>> slip;

    template <class D> static void describe(D& d) {
        using S = DifferentialDriveSignals;
        d.command("linearVelocity", &S::linearVelocity, "m/s", "Of the middle of the axle.");
        d.command("angularVelocity", &S::angularVelocity, "rad/s", "Positive turns left.");
        d.command("linearAmount", &S::linearAmount, "m", "Stop after this; 0: no limit.");
        d.command("angularAmount", &S::angularAmount, "rad", "Stop after this; 0: no limit.");
        d.command("sequence", &S::sequence, "", "A change starts the amounts.");
        d.truth("pose", &S::pose, "", "True x [m], y [m], heading [rad] of the middle of the axle in the world.");
        d.output("odometry", &S::odometry, "", "The same from the wheels' angles, counted from the start.");
        d.output("done", &S::done, "", "No amount is under way.");
        d.output("busy", &S::busy, "", "An amount is under way.");
        d.output("finished", &S::finished, "", "Sequence number of the amount last ended or refused.");
        d.truth("slip", &S::slip, "m/s",
                "By which the wheels on the left and on the right roll faster than their axle moves, on average.");
    }
};

struct RotaryMotorSignals {
    static constexpr const char* kKind = "RotaryMotor";
    CommandSlot<double> voltage, targetRate;
    CommandSlot<bool> servo;
    OutputSlot<double> current, terminalVoltage, torque, rate;
    OutputSlot<bool> saturated;
    OutputSlot<double> temperature;

    template <class D> static void describe(D& d) {
        using S = RotaryMotorSignals;
        d.command("voltage", &S::voltage, "V", "Clipped to MaxVoltage.");
        d.command("targetRate", &S::targetRate, "rad/s", "Of the joint, while servo is set.");
        d.command("servo", &S::servo, "",
                  "Holds targetRate, with at most the torque of MaxVoltage, instead of following the voltage.");
        d.output("current", &S::current, "A", "Through the winding.");
        d.output("terminalVoltage", &S::terminalVoltage, "V",
                 "Across the winding: the voltage as clipped, or what a servo's rate takes.");
        d.output("torque", &S::torque, "N m", "At the joint, at the end of the last tick.");
        d.output("rate", &S::rate, "rad/s", "Of the joint.");
        d.output("saturated", &S::saturated, "",
                 "MaxVoltage or CurrentLimit is not enough: one of them limits the motor, or the servo does not reach its rate.");
        d.output("temperature", &S::temperature, "degC", "Of the winding; without a ThermalResistance the ambient one.");
    }
};

struct EncoderSignals {
    static constexpr const char* kKind = "Encoder";
    OutputSlot<std::int64_t> count;
    OutputSlot<double> angle, rate;
    OutputSlot<bool> index;
    OutputSlot<std::int64_t> missed;

    template <class D> static void describe(D& d) {
        using S = EncoderSignals;
        d.output("count", &S::count, "",
                 "Counts since the start, negative backwards; of an absolute encoder the code of its position.");
        d.output("angle", &S::angle, "rad", "The angle that the count represents; on a Slider the way, m.");
        d.output("rate", &S::rate, "rad/s", "Counts of the last tick as a rate; on a Slider m/s.");
        d.output("index", &S::index, "", "In the last tick the index mark passed.");
        d.output("missed", &S::missed, "", "Counts that passed faster than MaxFrequency and were lost, since the start.");
    }
};

struct TouchSensorSignals {
    static constexpr const char* kKind = "TouchSensor";
    OutputSlot<bool> pressed;
    OutputSlot<double> force;
    OutputSlot<std::int64_t> count;

    template <class D> static void describe(D& d) {
        using S = TouchSensorSignals;
        d.output("pressed", &S::pressed, "", "Something touches.");
        d.output("force", &S::force, "N", "Sum of the contacts' normal forces.");
        d.output("count", &S::count, "", "Contact points.");
    }
};

struct CameraSignals {
    static constexpr const char* kKind = "Camera";
    OutputSlot<std::int64_t> frame;
    OutputSlot<double> time;

    template <class D> static void describe(D& d) {
        using S = CameraSignals;
        d.output("frame", &S::frame, "", "Number of its newest picture.");
        d.output("time", &S::time, "s", "When that was taken.");
    }
};

/// The state of a robot, and of each of its bodies, that a real robot cannot measure.
struct GroundTruthSignals {
    static constexpr const char* kKind = "GroundTruth";
    TruthSlot<std::array<double, 7>> pose;
    TruthSlot<std::array<double, 6>> velocity;

    template <class D> static void describe(D& d) {
        using S = GroundTruthSignals;
        d.truth("pose", &S::pose, "m", "Position x, y, z [m] and quaternion w, x, y, z in the world.");
        d.truth("velocity", &S::velocity, "m/s", "Of its origin [m/s] and of its rotation [rad/s], in the world.");
    }
};

/// A base with any number of driven wheels on each side: signals as of a DifferentialDrive. Since 1.8.
struct SkidDriveSignals : DifferentialDriveSignals {
    static constexpr const char* kKind = "SkidDrive";
};

/// A base on two tracks: signals as of a DifferentialDrive. Since 1.10.
struct TrackDriveSignals : DifferentialDriveSignals {
    static constexpr const char* kKind = "TrackDrive";
};

} // namespace sdk1
} // namespace trundle
