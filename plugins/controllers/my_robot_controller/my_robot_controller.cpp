// The controller that the text of thesis fig. 3.4 names. What its one field means is ours: how long the robot drives.
#include <trundle/controller.h>

namespace {

struct MyRobotController : trundle::Controller {
    double seconds = 5;

    static void describe(trundle::Describe<MyRobotController>& d) {
        d.help("Drives forwards for RobotControllerVar seconds where the robot has a drive named base, then stops.");
        d.field("RobotControllerVar", &MyRobotController::seconds, trundle::seconds().within(0, 1e6), "How long it drives.");
    }

    void setup(trundle::RobotPorts& robot) override {
        if (robot.has("base")) drive = robot.differentialDrive("base"); // else it stands, as the port ignores what it is told
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
