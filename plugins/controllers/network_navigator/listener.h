#pragma once
// Base of controllers that turn in place to measure the bearings of radios.
#include <numbers>
#include <string>

#include <trundle/controller.h>

#include "sweep.h"

inline constexpr double kDegree = std::numbers::pi / 180;

/// A drive, a radio with a forward-facing antenna, and the samples of the last sweep.
struct Listener : trundle::Controller {
    double turnRate = 0.5;
    std::string radioName = "radio", driveName = "base";

    template <class T> static void describeListener(trundle::Describe<T>& d) {
        d.field("TurnRate", &T::turnRate, trundle::radiansPerSecond().above(0).atMost(10), "While it listens.");
        d.field("Radio", &T::radioName, trundle::needs("Transceiver"), "The robot's Transceiver, whose antenna looks ahead.");
        d.field("Drive", &T::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

protected:
    void bindListener(trundle::RobotPorts& robot) {
        drive = robot.differentialDrive(driveName);
        radio = robot.radio(radioName);
    }
    /// Turns a little more than once around, so that no peak is at the start or end of the sweep.
    void beginSweep() {
        sweep.clear();
        drive.turn(turnRate, 370 * kDegree);
    }
    /// Received packets belong to the heading one tick ago, when they were received.
    template <class Hear> void listen(const Hear& hear) {
        while (const auto packet = radio.receive()) hear(*packet, lastHeading);
        lastHeading = drive.odometry().heading;
    }

    trundle::DifferentialDrivePort drive;
    trundle::RadioPort radio;
    Sweep sweep;
    double lastHeading = 0;
};
