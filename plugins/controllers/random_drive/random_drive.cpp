// Drives randomly: every Period it chooses a new speed and turn rate. For swarms and speed measurements.
#include <trundle/controller.h>

namespace {

struct RandomDrive : trundle::Controller {
    double speed = 0.3;
    double turnRate = 1;
    double period = 1;
    std::string driveName = "base";

    static void describe(trundle::Describe<RandomDrive>& d) {
        d.help("Drives with a new random speed and turn rate every Period.").independent();
        d.field("Speed", &RandomDrive::speed, trundle::metresPerSecond().within(0, 10).live(),
                "Largest speed; a quarter of it backwards.");
        d.field("TurnRate", &RandomDrive::turnRate, trundle::radiansPerSecond().within(0, 100).live(),
                "Largest turn rate, to either side.");
        d.field("Period", &RandomDrive::period, trundle::seconds().above(0).atMost(1e6), "Time between changes.");
        d.field("Drive", &RandomDrive::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
    }

    void setup(trundle::RobotPorts& robot) override { drive = robot.differentialDrive(driveName); }

    void update(trundle::Seconds) override {
        if (time() < nextChange * period) return;
        nextChange += 1;
        const double forward = random(-0.25, 1);
        drive.move(speed * forward, turnRate * random(-1, 1));
    }

private:
    trundle::DifferentialDrivePort drive;
    double nextChange = 0; // in periods; an integer count, so that it does not drift
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<RandomDrive>("RandomDrive"); }
