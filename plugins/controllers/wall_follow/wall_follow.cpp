// Follows the walls of a room at a constant distance, by the ranges of a level lidar alone, until it is back where it began.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <trundle/controller.h>

namespace {

constexpr double kDegree = std::numbers::pi / 180;

double distanceOf(const trundle::Pose2& a, const trundle::Pose2& b) {
    return std::sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y));
}

struct WallFollow : trundle::Controller {
    double speed = 0.15;
    double distance = 0.3;
    double turnRate = 1.5;
    double fieldOfView = 360 * kDegree;
    int laps = 1;
    std::string side = "left", lidarName = "scan", driveName = "base";
    trundle::OutputSlot<double> gap;
    trundle::OutputSlot<int> lap;

    static void describe(trundle::Describe<WallFollow>& d) {
        d.help("Drives ahead until there is a wall, follows it at a distance, and ends the run when it is back at its beginning.")
            .independent();
        d.field("Speed", &WallFollow::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "Along the wall.");
        d.field("Distance", &WallFollow::distance, trundle::metres().above(0).atMost(100).live(), "From the lidar to the wall.");
        d.field("TurnRate", &WallFollow::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(), "At most.");
        d.field("Side", &WallFollow::side, trundle::oneOf("left|right"), "Where the wall is kept.");
        d.field("Laps", &WallFollow::laps, trundle::number().within(1, 1000), "Rounds after which it ends the run.");
        d.field("FieldOfView", &WallFollow::fieldOfView, trundle::degrees().above(0).atMost(360), "That of the lidar.");
        d.field("Lidar", &WallFollow::lidarName, trundle::needs("Lidar"), "The robot's Lidar.");
        d.field("Drive", &WallFollow::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
        d.output("gap", &WallFollow::gap, "m", "Distance of the nearest wall on its side.");
        d.output("lap", &WallFollow::lap, "", "Rounds done.");
    }

    void setup(trundle::RobotPorts& robot) override {
        lidar = robot.lidar(lidarName);
        drive = robot.differentialDrive(driveName);
        sign = side == "left" ? 1 : -1;
    }

    void update(trundle::Seconds) override {
        if (!lidar.fresh()) return; // a scan, not a tick, is its step
        if (following) countLaps();
        const Echo ahead = nearest(-30 * kDegree, 50 * kDegree);
        if (!following && ahead.range > distance) return drive.move(speed, 0);
        if (!following) begin();
        const Echo wall = nearest(30 * kDegree, 135 * kDegree);
        gap.set(wall.range);
        if (ahead.range < 1.05 * distance) return drive.move(0, -sign * 0.6 * turnRate); // a corner: away from the wall
        const double towards = std::clamp(3 * (wall.range - distance), -0.7, 0.7);       // rad
        const double error = wall.bearing - 90 * kDegree + towards;
        const double turn = std::clamp(2.5 * error, -turnRate, turnRate);
        drive.move(speed * std::clamp(1 - std::abs(error), 0.3, 1.0), sign * turn);
    }

private:
    struct Echo {
        double range, bearing; ///< m; rad, positive on the side of the wall
    };

    /// The nearest thing between two bearings. A single stray beam does not count: each is the middle one of three neighbours.
    Echo nearest(double from, double to) const {
        const auto all = lidar.ranges();
        const auto count = static_cast<int>(all.size());
        const bool closed = fieldOfView > 359.9 * kDegree;
        const double step = fieldOfView / std::max(1, closed ? count : count - 1);
        Echo best{1e9, 0};
        for (int i = 0; i < count; ++i) {
            const double bearing = sign * (-fieldOfView / 2 + i * step);
            if (bearing < from || bearing > to) continue;
            const double a = all[static_cast<std::size_t>((i + count - 1) % count)], b = all[static_cast<std::size_t>(i)],
                         c = all[static_cast<std::size_t>((i + 1) % count)];
            const double middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
            if (middle < best.range) best = {middle, bearing};
        }
        return best;
    }

    void begin() {
        following = true;
        start = last = drive.odometry();
        print("follows the wall on its ", side);
    }

    /// A round is a full turn that ends near its beginning, both by odometry.
    void countLaps() {
        const trundle::Pose2 now = drive.odometry();
        travelled += distanceOf(now, last);
        turned += std::remainder(now.heading - last.heading, 2 * std::numbers::pi);
        last = now;
        const bool isBack = distanceOf(now, start) < 1.2 * distance;
        if (!isBack || travelled < 8 * distance || std::abs(turned) < 300 * kDegree) return;
        lap.set(lap.get() + 1);
        print("round ", lap.get(), " of ", laps, ": ", travelled, " m");
        if (lap.get() >= laps) {
            drive.stop();
            finish("went around");
        }
        travelled = turned = 0;
    }

    trundle::LidarPort lidar;
    trundle::DifferentialDrivePort drive;
    double sign = 1;
    bool following = false;
    trundle::Pose2 start, last;
    double travelled = 0, turned = 0; ///< m, rad; in this round
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<WallFollow>("WallFollow"); }
