#pragma once
// A robot that turns on the spot with open ears.
#include <numbers>
#include <string>

#include <trundle/controller.h>

#include "sweep.h"

inline constexpr double kDegree = std::numbers::pi / 180;

/// A drive, a radio whose antenna looks ahead, and what it heard from where in its last turn.
struct Listener : trundle::Controller {
    double turnRate = 0.5;
    std::string radioName = "radio", driveName = "base";

    template <class T> static void describeListener(trundle::Describe<T>& d) {
        d.field("TurnRate", &T::turnRate, trundle::radiansPerSecond().above(0).atMost(10), "While it listens.");
        d.field("Radio", &T::radioName, trundle::text(), "The robot's Transceiver, whose antenna looks ahead.");
        d.field("Drive", &T::driveName, trundle::text(), "The robot's DifferentialDrive.");
    }

protected:
    void bindListener(trundle::RobotPorts& robot) {
        drive = robot.differentialDrive(driveName);
        radio = robot.radio(radioName);
    }
    /// Once around, and a little more, so that no peak lies at a seam.
    void beginSweep() {
        sweep.clear();
        drive.turn(turnRate, 370 * kDegree);
    }
    /// What came in belongs to the heading at which it was heard, a tick ago.
    template <class Hear> void listen(const Hear& hear) {
        while (const auto packet = radio.receive()) hear(*packet, lastHeading);
        lastHeading = drive.odometry().heading;
    }

    trundle::DifferentialDrivePort drive;
    trundle::RadioPort radio;
    Sweep sweep;
    double lastHeading = 0;
};
