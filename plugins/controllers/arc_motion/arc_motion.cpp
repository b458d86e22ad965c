// Drives along a circle by a given angle and stops; compares commanded and driven angle.
#include <cmath>
#include <numbers>

#include <trundle/controller.h>

namespace {

struct ArcMotion : trundle::Controller {
    double speed = 0.3;
    double turnRate = 1;
    double angle = 2 * std::numbers::pi;
    std::string driveName = "base";

    static void describe(trundle::Describe<ArcMotion>& d) {
        d.help("Drives along a circle of radius Speed / TurnRate until it has turned by Angle, then stops.").independent();
        d.field("Speed", &ArcMotion::speed, trundle::metresPerSecond().within(-10, 10), "Along the circle; 0 turns on the spot.");
        d.field("TurnRate", &ArcMotion::turnRate, trundle::radiansPerSecond().above(0).atMost(100), "How fast it turns.");
        d.field("Angle", &ArcMotion::angle, trundle::degrees().within(-36000, 36000), "Positive turns left.");
        d.field("Drive", &ArcMotion::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override { drive = robot.differentialDrive(driveName); }

    void update(trundle::Seconds) override {
        if (!started) {
            started = true;
            drive.drive(speed, std::copysign(turnRate, angle), 0, angle);
        } else if (!finished && drive.done()) {
            finished = true;
            constexpr double kDegrees = 180 / std::numbers::pi;
            print("done: turned ", drive.odometry().heading * kDegrees, " deg of ", angle * kDegrees, " deg by odometry");
        }
    }

    trundle::DifferentialDrivePort drive;
    bool started = false, finished = false;
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<ArcMotion>("ArcMotion"); }
