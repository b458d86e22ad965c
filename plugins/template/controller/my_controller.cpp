// A controller that drives a circle: a start for your own. Once it is built, an experiment beside this folder uses it with
//
//     #loadModule my_controller/build/my_controller
//     Robot robot0 { Config=SimpleRobot  MyController brain { Speed = 0.2 } }
//
// The guide says what a controller can do besides: sensors, cameras, radios, values for logs, ending the run.
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
