// The controller named in the text of thesis fig. 3.4. The meaning of its one field, how long the robot drives, is defined here.
#include <trundle/controller.h>

namespace {

struct MyRobotController : trundle::Controller {
    double seconds = 5;

    static void describe(trundle::Describe<MyRobotController>& d) {
        d.help("Drives forwards for RobotControllerVar seconds where the robot has a drive named base, then stops.")
            .independent();
        d.field("RobotControllerVar", &MyRobotController::seconds, trundle::seconds().within(0, 1e6), "How long it drives.");
    }

    void setup(trundle::RobotPorts& robot) override {
        if (robot.has("base")) drive = robot.differentialDrive("base"); // otherwise unbound: the robot does not move
    }

    void update(trundle::Seconds) override {
        if (time() < seconds) drive.move(kSpeed, 0);
        else drive.stop();
    }

private:
    static constexpr double kSpeed = 0.2; // m/s
    trundle::DifferentialDrivePort drive;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<MyRobotController>("MyRobotController"); }
