// Finds a dark line on a light floor and follows it, by three ground sensors alone, until it is back where it began.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <trundle/controller.h>

namespace {

double distanceOf(const trundle::Pose2& a, const trundle::Pose2& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

struct LineFollow : trundle::Controller {
    double speed = 0.08;
    double turnRate = 3;
    double threshold = 0.3;
    int laps = 1;
    std::string left = "leftGround", middle = "middleGround", right = "rightGround", driveName = "base";
    trundle::OutputSlot<double> offset;
    trundle::OutputSlot<int> lap;

    static void describe(trundle::Describe<LineFollow>& d) {
        d.help("Drives ahead until it sees a dark line, follows it, and ends the run when it is back at its beginning.")
            .independent();
        d.field("Speed", &LineFollow::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "Where the line is straight.");
        d.field("TurnRate", &LineFollow::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(), "At most.");
        d.field("Threshold", &LineFollow::threshold, trundle::number().within(0.01, 1).live(),
                "Reflectance halfway from the line to the floor.");
        d.field("Laps", &LineFollow::laps, trundle::number().within(1, 1000), "Rounds after which it ends the run.");
        d.field("Left", &LineFollow::left, trundle::needs("GroundSensor"), "The robot's GroundSensor on the left.");
        d.field("Middle", &LineFollow::middle, trundle::needs("GroundSensor"), "The one in the middle.");
        d.field("Right", &LineFollow::right, trundle::needs("GroundSensor"), "The one on the right.");
        d.field("Drive", &LineFollow::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
        d.output("offset", &LineFollow::offset, "", "Where the line is: 1 below the left sensor, -1 below the right one.");
        d.output("lap", &LineFollow::lap, "", "Rounds done.");
    }

    void setup(trundle::RobotPorts& robot) override {
        sensors[0] = robot.groundSensor(left);
        sensors[1] = robot.groundSensor(middle);
        sensors[2] = robot.groundSensor(right);
        drive = robot.differentialDrive(driveName);
    }

    void update(trundle::Seconds) override {
        double dark[3], sum = 0;
        for (int i = 0; i < 3; ++i) {
            dark[i] = sensors[i].time() < 0 ? 0 : std::clamp(1 - sensors[i].reflectance() / (2 * threshold), 0.0, 1.0);
            sum += dark[i];
        }
        const bool seen = *std::max_element(dark, dark + 3) > 0.5;
        if (!following) {
            if (!seen) return drive.move(speed, 0);
            begin();
        }
        countLaps();
        if (lap.get() >= laps) return;
        if (!seen) return drive.move(0, side * 0.6 * turnRate); // back to where it was last
        offset.set((dark[0] - dark[2]) / sum);
        if (std::abs(offset.get()) > 0.2) side = offset.get() > 0 ? 1 : -1;
        drive.move(speed * (1 - 0.6 * std::abs(offset.get())), turnRate * offset.get());
    }

private:
    void begin() {
        following = true;
        start = last = drive.odometry();
        print("found the line");
    }

    /// A round is a full turn that ends near its beginning, both by odometry.
    void countLaps() {
        const trundle::Pose2 now = drive.odometry();
        travelled += distanceOf(now, last);
        turned += std::remainder(now.heading - last.heading, 2 * std::numbers::pi);
        last = now;
        const bool isBack = distanceOf(now, start) < 0.1;
        if (!isBack || travelled < 1 || std::abs(turned) < 1.5 * std::numbers::pi) return;
        lap.set(lap.get() + 1);
        print("round ", lap.get(), " of ", laps, ": ", travelled, " m");
        if (lap.get() >= laps) {
            drive.stop();
            finish("went around");
        }
        travelled = turned = 0;
    }

    trundle::GroundPort sensors[3]; ///< left, middle, right
    trundle::DifferentialDrivePort drive;
    bool following = false;
    double side = 1; ///< where the line was last: 1 left, -1 right
    trundle::Pose2 start, last;
    double travelled = 0, turned = 0; ///< m, rad; in this round
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<LineFollow>("LineFollow"); }
