// A controller of one motor, so that several of them share a robot.
#include <cstdlib>
#include <stdexcept>

#include <trundle/controller.h>

namespace {

struct Half : trundle::Controller {
    std::string motor, end = "none";
    double voltage = 3, noise = 0;

    static void describe(trundle::Describe<Half>& d) {
        d.help("Drives one motor.");
        d.field("Motor", &Half::motor, trundle::text().required(), "The motor that it commands.");
        d.field("Voltage", &Half::voltage, trundle::volts(), "What it commands.");
        d.field("Noise", &Half::noise, trundle::volts().within(0, 10), "Added to that: between 0 and this.");
        d.field("End", &Half::end, trundle::oneOf("none|throw|abort"), "What it does at 0.5 s.");
        d.output("drawn", "", "The last random number.");
    }
    void setup(trundle::RobotPorts& robot) override {
        port = robot.motor(motor);
        drawn = robot.publish("drawn");
    }
    void update(trundle::Seconds) override {
        if (time() > 0.5 && end == "throw") throw std::runtime_error("no more");
        if (time() > 0.5 && end == "abort") std::abort();
        drawn.set(random());
        port.setVoltage(voltage + noise * drawn.get());
    }
    trundle::MotorPort port;
    trundle::Slot drawn;
};

/// The same with both motors.
struct Both : trundle::Controller {
    double left = 3, right = 3;
    static void describe(trundle::Describe<Both>& d) {
        d.help("Drives both motors.");
        d.field("Left", &Both::left, trundle::volts(), "Of leftMotor.");
        d.field("Right", &Both::right, trundle::volts(), "Of rightMotor.");
    }
    void setup(trundle::RobotPorts& robot) override {
        leftPort = robot.motor("leftMotor");
        rightPort = robot.motor("rightMotor");
    }
    void update(trundle::Seconds) override {
        leftPort.setVoltage(left);
        rightPort.setVoltage(right);
    }
    trundle::MotorPort leftPort, rightPort;
};

} // namespace

TRUNDLE_MODULE(registry) {
    registry.controller<Half>("Half");
    registry.controller<Both>("Both");
}
