// The smallest controller: drives a circle. Copy this folder, rename MyController, and add
//
//     #loadModule template
//     Robot robot0 { Config=SimpleRobot  MyController brain { Speed = 0.2 } }
//
// to an experiment. Other features of controllers (sensors, cameras, radios, published values for logs, ending the run):
// core/sdk/README.md.
#include <trundle/controller.h>

struct MyController : trundle::Controller {
    double speed = 0.2;
    double turnRate = 0.5;

    static void describe(trundle::Describe<MyController>& d) {
        d.help("Drives a circle.");
        d.field("Speed", &MyController::speed, trundle::metresPerSecond().within(-2, 2), "Along the circle.");
        d.field("TurnRate", &MyController::turnRate, trundle::radiansPerSecond().within(-5, 5), "Positive turns left.");
    }

    void setup(trundle::RobotPorts& robot) override { drive = robot.differentialDrive("base"); }

    void update(trundle::Seconds) override { drive.move(speed, turnRate); }

    trundle::DifferentialDrivePort drive;
};

TRUNDLE_MODULE(registry) { registry.controller<MyController>("MyController"); }
