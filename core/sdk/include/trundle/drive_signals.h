// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Signals as in device_signals.h: of bases that move in any direction, or steer their wheels. Since 1.9.

#include <array>
#include <cstdint>

#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// A base with omni-directional wheels.
struct OmniDriveSignals {
    static constexpr const char* kKind = "OmniDrive";
    CommandSlot<double> linearVelocity, lateralVelocity, angularVelocity, linearAmount, angularAmount;
    CommandSlot<std::int64_t> sequence;
    TruthSlot<std::array<double, 3>> pose;
    OutputSlot<std::array<double, 3>> odometry;
    OutputSlot<bool> done, busy;
    OutputSlot<std::int64_t> finished;
    TruthSlot<std::array<double, 3>> slip;

    template <class D> static void describe(D& d) {
        using S = OmniDriveSignals;
        d.command("linearVelocity", &S::linearVelocity, "m/s", "Of its middle, forwards.");
        d.command("lateralVelocity", &S::lateralVelocity, "m/s", "Of its middle, to the left.");
        d.command("angularVelocity", &S::angularVelocity, "rad/s", "Positive turns left.");
        d.command("linearAmount", &S::linearAmount, "m", "Stop after this way along the velocity; 0: no limit.");
        d.command("angularAmount", &S::angularAmount, "rad", "Stop after this; 0: no limit.");
        d.command("sequence", &S::sequence, "", "A change starts the amounts.");
        d.truth("pose", &S::pose, "", "True x [m], y [m], heading [rad] of its middle in the world.");
        d.output("odometry", &S::odometry, "", "The same from the wheels' angles, counted from the start.");
        d.output("done", &S::done, "", "No amount is under way.");
        d.output("busy", &S::busy, "", "An amount is under way.");
        d.output("finished", &S::finished, "", "Sequence number of the amount last ended or refused.");
        d.truth("slip", &S::slip, "", "By which the wheels would move it faster than it moves: forwards, to the left [m/s], to the left turning [rad/s].");
    }
};

/// A base with four mecanum wheels: signals as of an OmniDrive.
struct MecanumDriveSignals : OmniDriveSignals {
    static constexpr const char* kKind = "MecanumDrive";
};

/// A base with driven wheels at the back and steered wheels in front.
struct AckermannDriveSignals {
    static constexpr const char* kKind = "AckermannDrive";
    CommandSlot<double> linearVelocity, steeringAngle, linearAmount;
    CommandSlot<std::int64_t> sequence;
    TruthSlot<std::array<double, 3>> pose;
    OutputSlot<double> steering;
    OutputSlot<std::array<double, 3>> odometry;
    OutputSlot<bool> done, busy;
    OutputSlot<std::int64_t> finished;
    TruthSlot<std::array<double, 2>> slip;

    template <class D> static void describe(D& d) {
        using S = AckermannDriveSignals;
        d.command("linearVelocity", &S::linearVelocity, "m/s", "Of the middle of the driven axle.");
        d.command("steeringAngle", &S::steeringAngle, "rad", "Of a wheel midway between the steered ones; positive turns left.");
        d.command("linearAmount", &S::linearAmount, "m", "Stop after this; 0: no limit.");
        d.command("sequence", &S::sequence, "", "A change starts the amount.");
        d.truth("pose", &S::pose, "", "True x [m], y [m], heading [rad] of the middle of the driven axle in the world.");
        d.output("steering", &S::steering, "rad", "The steering angle that it has.");
        d.output("odometry", &S::odometry, "", "As pose, from the angles of the driven wheels, counted from the start.");
        d.output("done", &S::done, "", "No amount is under way.");
        d.output("busy", &S::busy, "", "An amount is under way.");
        d.output("finished", &S::finished, "", "Sequence number of the amount last ended or refused.");
        d.truth("slip", &S::slip, "m/s", "By which the driven wheels on the left and on the right roll faster than their axle moves.");
    }
};

} // namespace sdk1
} // namespace trundle
