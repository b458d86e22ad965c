// Drives a given distance along a straight line and stops; compares commanded and driven distance.
#include <cmath>

#include <trundle/controller.h>

namespace {

struct LinearMotion : trundle::Controller {
    double distance = 1;
    double speed = 0.2;
    std::string driveName = "base";

    static void describe(trundle::Describe<LinearMotion>& d) {
        d.help("Drives straight for a distance, then stops and says how far that was by odometry.").independent();
        d.field("Distance", &LinearMotion::distance, trundle::metres().within(-1e4, 1e4), "Negative drives backwards.");
        d.field("Speed", &LinearMotion::speed, trundle::metresPerSecond().above(0).atMost(10), "Cruising speed.");
        d.field("Drive", &LinearMotion::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override { drive = robot.differentialDrive(driveName); }

    void update(trundle::Seconds) override {
        if (!started) {
            started = true;
            drive.drive(std::copysign(speed, distance), 0, distance, 0);
        } else if (!finished && drive.done()) {
            finished = true;
            const auto at = drive.odometry();
            print("done: drove ", std::hypot(at.x, at.y), " m of ", std::abs(distance), " m by odometry");
        }
    }

    trundle::DifferentialDrivePort drive;
    bool started = false, finished = false;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<LinearMotion>("LinearMotion"); }
