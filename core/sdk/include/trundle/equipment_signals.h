// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// Signals as in device_signals.h: of servos, grippers, batteries, lights.

#include <array>
#include <cstdint>
#include <vector>

#include <trundle/slot.h>

namespace trundle {
inline namespace sdk1 {

/// Since 1.7.
struct ServoSignals {
    static constexpr const char* kKind = "Servo";
    CommandSlot<double> target;
    OutputSlot<double> position, rate, torque;
    OutputSlot<bool> saturated;

    template <class D> static void describe(D& d) {
        using S = ServoSignals;
        d.command("target", &S::target, "", "Position [rad] or, with Mode=speed, rate [rad/s] that the joint is to have.");
        d.output("position", &S::position, "rad", "Of the joint, 0 in its start pose.");
        d.output("rate", &S::rate, "rad/s", "Of the joint.");
        d.output("torque", &S::torque, "N m", "On the joint, at the end of the last tick.");
        d.output("saturated", &S::saturated, "", "MaxTorque or MaxSpeed is not enough for its target.");
    }
};

/// Since 1.7.
struct LinearMotorSignals {
    static constexpr const char* kKind = "LinearMotor";
    CommandSlot<double> target;
    OutputSlot<double> position, rate, force;
    OutputSlot<bool> saturated;

    template <class D> static void describe(D& d) {
        using S = LinearMotorSignals;
        d.command("target", &S::target, "", "Position [m] or, with Mode=speed, speed [m/s] that the joint is to have.");
        d.output("position", &S::position, "m", "Of the joint, 0 in its start pose.");
        d.output("rate", &S::rate, "m/s", "Of the joint.");
        d.output("force", &S::force, "N", "On the joint, at the end of the last tick.");
        d.output("saturated", &S::saturated, "", "MaxForce or MaxSpeed is not enough for its target.");
    }
};

// Since 1.8.

struct BatterySignals {
    static constexpr const char* kKind = "Battery";
    OutputSlot<double> voltage, current, charge, level, chargeCurrent;
    TruthSlot<double> openVoltage;

    template <class D> static void describe(D& d) {
        using S = BatterySignals;
        d.output("voltage", &S::voltage, "V", "Between its terminals; 0 when it is empty.");
        d.output("current", &S::current, "A", "Of all that draw from it; negative while it is charged.");
        d.output("charge", &S::charge, "C", "That is left.");
        d.output("level", &S::level, "", "Share of Capacity that is left, from 0 to 1.");
        d.output("chargeCurrent", &S::chargeCurrent, "A", "From a Charger that its Contact touches.");
        d.truth("openVoltage", &S::openVoltage, "V", "Its voltage without a load.");
    }
};

struct GripperSignals {
    static constexpr const char* kKind = "Gripper";
    CommandSlot<double> opening;
    OutputSlot<double> position, force;
    OutputSlot<bool> holding;

    template <class D> static void describe(D& d) {
        using S = GripperSignals;
        d.command("opening", &S::opening, "m", "Change of the distance between its jaws from the start pose; negative closes.");
        d.output("position", &S::position, "m", "The change that they have.");
        d.output("force", &S::force, "N", "With which its jaws press against each other; negative: apart.");
        d.output("holding", &S::holding, "", "It closes with all of its force, and its jaws do not move.");
    }
};

// Since 1.10.

struct BeltSignals {
    static constexpr const char* kKind = "Belt";
    CommandSlot<double> speed;
    OutputSlot<double> rate, travel;

    template <class D> static void describe(D& d) {
        using S = BeltSignals;
        d.command("speed", &S::speed, "m/s", "At which it is to run; at most MaxSpeed.");
        d.output("rate", &S::rate, "m/s", "At which it runs.");
        d.output("travel", &S::travel, "m", "Way of its surface since the start, negative backwards.");
    }
};

struct TrackSignals {
    static constexpr const char* kKind = "Track";
    CommandSlot<double> speed;
    OutputSlot<double> rate, travel;

    template <class D> static void describe(D& d) {
        using S = TrackSignals;
        d.command("speed", &S::speed, "m/s", "At which it is to drive, positive forwards; at most MaxSpeed.");
        d.output("rate", &S::rate, "m/s", "At which it runs.");
        d.output("travel", &S::travel, "m", "Way that it has run since the start, negative backwards.");
    }
};

struct PenSignals {
    static constexpr const char* kKind = "Pen";
    CommandSlot<bool> down;
    OutputSlot<double> length;
    OutputSlot<std::int64_t> points;
    TruthSlot<std::vector<std::array<double, 4>>> line;

    template <class D> static void describe(D& d) {
        using S = PenSignals;
        d.command("down", &S::down, "", "It draws.");
        d.output("length", &S::length, "m", "Of all that it has drawn.");
        d.output("points", &S::points, "", "Of its line, at most MaxPoints.");
        d.truth("line", &S::line, "", "Of each point x, y, z [m] in the world, and 1 where a stroke begins, else 0.",
                {"MaxPoints"});
    }
};

struct LedSignals {
    static constexpr const char* kKind = "Led";
    CommandSlot<bool> on;
    CommandSlot<std::array<double, 3>> color;
    OutputSlot<bool> lit;

    template <class D> static void describe(D& d) {
        using S = LedSignals;
        d.command("on", &S::on, "", "Whether it is to shine.");
        d.command("color", &S::color, "", "Red, green, blue from 0 to 1, as in pictures.");
        d.output("lit", &S::lit, "", "It shines: it is on and has power.");
    }
};

struct ChargerSignals {
    static constexpr const char* kKind = "Charger";
    OutputSlot<bool> connected;
    OutputSlot<double> voltage, current, energy;

    template <class D> static void describe(D& d) {
        using S = ChargerSignals;
        d.output("connected", &S::connected, "", "A battery takes power.");
        d.output("voltage", &S::voltage, "V", "At which it charges; without a battery its Voltage.");
        d.output("current", &S::current, "A", "Into the batteries that it charges.");
        d.output("energy", &S::energy, "J", "That it has given since the start.");
    }
};

// Since 1.11.

struct LatchSignals {
    static constexpr const char* kKind = "Latch";
    CommandSlot<bool> engage;
    OutputSlot<bool> engaged, inReach;
    OutputSlot<double> force;

    template <class D> static void describe(D& d) {
        using S = LatchSignals;
        d.command("engage", &S::engage, "", "It is to hold what is within Reach; it releases that when this ends.");
        d.output("engaged", &S::engaged, "", "It holds something.");
        d.output("inReach", &S::inReach, "", "Something that it could hold is within Reach.");
        d.output("force", &S::force, "N", "Between it and what it holds, in the last tick.");
    }
};

} // namespace sdk1
} // namespace trundle
