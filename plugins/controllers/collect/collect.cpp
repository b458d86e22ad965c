// Finds cylinders with a lidar, grips them one after the other, and puts them down in a row at home. Sonars see what is beside and behind it.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <trundle/controller.h>

#include "scan_points.h"

using collect::Point, collect::ScanPoints;

namespace {

constexpr double kPi = std::numbers::pi, kDegree = kPi / 180;
constexpr double kAlign = 0.65;    // m from the axle to a cylinder: here it turns to it before it drives on to grip it
constexpr double kLane = 0.52;     // m: what it needs beside nothing
constexpr double kRetreat = 0.5;   // m back from what it has put down
constexpr double kSameThing = 0.3; // m between where a cylinder was and is seen
constexpr double kReleased = 0.15; // m back: its jaws are clear of what it has put down
constexpr double kPass = 0.1;      // m/s with which it passes what its back would swing into

double wrapped(double angle) { return std::remainder(angle, 2 * kPi); }

struct Collect : trundle::Controller {
    int count = 6;
    double radius = 0.04;
    std::array<double, 2> home{-0.9, 0};
    double spacing = 0.34;
    std::vector<double> survey{1.5, 0};
    double speed = 0.4;
    double turnRate = 0.8;
    double grip = 0.315;
    double lidarAhead = 0.165, fieldOfView = 240 * kDegree, maxRange = 4;
    std::vector<std::string> sonarNames{"sonar0", "sonar1", "sonar2",  "sonar3",  "sonar4",  "sonar5",  "sonar6",  "sonar7",
                                        "sonar8", "sonar9", "sonar10", "sonar11", "sonar12", "sonar13", "sonar14", "sonar15"};
    std::vector<double> sonarBearings = {
        90 * kDegree,  50 * kDegree,   30 * kDegree,   10 * kDegree,   -10 * kDegree, -30 * kDegree, -50 * kDegree, -90 * kDegree,
        -90 * kDegree, -130 * kDegree, -150 * kDegree, -170 * kDegree, 170 * kDegree, 150 * kDegree, 130 * kDegree, 90 * kDegree};
    double clearance = 0.2;
    std::string lidarName = "scan", gripperName = "gripper", liftName = "lift", driveName = "base";
    trundle::OutputSlot<int> delivered;

    static void describe(trundle::Describe<Collect>& d) {
        using C = Collect;
        d.help(
             "Finds cylinders with its lidar, grips them, puts them down in a row at home, and ends the run when all are there.")
            .independent();
        d.field("Count", &C::count, trundle::number().within(1, 100), "Cylinders to bring.");
        d.field("Radius", &C::radius, trundle::metres().within(0.01, 0.5), "Of a cylinder.");
        d.field("Home", &C::home, trundle::metres(), "Middle of the row that it makes at home, seen from its start, x ahead.");
        d.field("Spacing", &C::spacing, trundle::metres().within(0.1, 10), "Between two cylinders in the row.");
        d.field("Survey", &C::survey, trundle::metres().counted(2, 100),
                "x, y, and so on: where it looks around if it sees none.");
        d.field("Speed", &C::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "At most.");
        d.field("TurnRate", &C::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(), "At most.");
        d.field("Grip", &C::grip, trundle::metres().within(0, 10), "From the axle to the middle of its jaws.");
        d.field("LidarAhead", &C::lidarAhead, trundle::metres().within(-10, 10), "From the axle to the lidar.");
        d.field("FieldOfView", &C::fieldOfView, trundle::degrees().above(0).atMost(360), "That of the lidar.");
        d.field("MaxRange", &C::maxRange, trundle::metres().above(0), "That of the lidar.");
        d.field("Sonars", &C::sonarNames, trundle::needs("RangeSensor").counted(0, 100), "RangeSensors around it.");
        d.field("SonarBearings", &C::sonarBearings, trundle::degrees().within(-180, 180).counted(0, 100),
                "Where each of them looks to, positive to the left.");
        d.field("Clearance", &C::clearance, trundle::metres().within(0, 10),
                "From its sonars to what it does not turn or drive back into.");
        d.field("Lidar", &C::lidarName, trundle::needs("Lidar"), "The robot's Lidar.");
        d.field("Gripper", &C::gripperName, trundle::needs("Gripper"), "The robot's Gripper; it is open at the start.");
        d.field("Lift", &C::liftName, trundle::needs("LinearMotor"), "The LinearMotor that lifts the gripper.");
        d.field("Drive", &C::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
        d.output("delivered", &C::delivered, "", "Cylinders at home.");
    }

    void setup(trundle::RobotPorts& robot) override {
        if (sonarBearings.size() != sonarNames.size()) return fail("Sonars and SonarBearings are not equally many");
        for (const std::string& name : sonarNames) sonars.push_back(robot.rangeSensor(name));
        lidar = robot.lidar(lidarName);
        gripper = robot.gripper(gripperName);
        lift = robot.linearMotor(liftName);
        drive = robot.differentialDrive(driveName);
    }

    void update(trundle::Seconds) override {
        if (!lidar.fresh()) return; // a scan, not a tick, is its step
        here = drive.odometry();
        const ScanPoints scan(lidar.ranges(), fieldOfView, lidarAhead, maxRange);
        switch (state) {
        case State::Search: return search(scan);
        case State::Survey: return driveToSurvey(scan);
        case State::Approach: return approach(scan);
        case State::Reach: return reach(scan);
        case State::Close: return close();
        case State::Carry: return carry(scan);
        case State::PutDown: return putDown();
        case State::Open: return open();
        case State::Retreat: return retreat();
        }
    }

private:
    enum class State { Search, Survey, Approach, Reach, Close, Carry, PutDown, Open, Retreat };

    void enter(State next) {
        state = next;
        since = time();
        turned = 0;
        lastHeading = here.heading;
        from = here;
        row = 0;
    }
    [[nodiscard]] double elapsed() const { return time() - since; } // s in this state

    /// A point of the robot's frame in that of its odometry, and back.
    [[nodiscard]] Point outside(Point p) const {
        const double c = std::cos(here.heading), s = std::sin(here.heading);
        return {here.x + c * p.x - s * p.y, here.y + s * p.x + c * p.y};
    }
    [[nodiscard]] Point inside(Point p) const {
        const double c = std::cos(here.heading), s = std::sin(here.heading), x = p.x - here.x, y = p.y - here.y;
        return {c * x + s * y, c * y - s * x};
    }
    [[nodiscard]] Point slot() const { return {home[0], home[1] + spacing * (delivered.get() - 0.5 * (count - 1))}; }

    /// The cylinder nearest to a point of the odometry's frame that is not at home. Nothing is farther than `within` m.
    [[nodiscard]] std::optional<Point> nearest(const ScanPoints& scan, Point to, double within) const {
        std::optional<Point> best;
        for (const Point& seen : scan.cylinders(radius)) {
            const Point p = outside(seen);
            if (std::abs(p.x - home[0]) < spacing && std::abs(p.y - home[1]) < spacing * (count + 1) / 2.0) continue;
            const double far = collect::length(p.x - to.x, p.y - to.y);
            if (far < within) within = far, best = p;
        }
        return best;
    }

    /// Turns around once, then goes to the nearest cylinder that it has seen.
    void search(const ScanPoints& scan) {
        if (const auto seen = nearest(scan, {here.x, here.y}, best ? bestFar : maxRange)) {
            best = seen;
            bestFar = collect::length(seen->x - here.x, seen->y - here.y);
        }
        turned += std::abs(wrapped(here.heading - lastHeading));
        lastHeading = here.heading;
        if (turned < 2 * kPi) return steer(scan, 0, turnRate, {}, 0);
        drive.stop();
        if (best) {
            target = *best;
            best.reset();
            return enter(State::Approach);
        }
        const std::size_t at = 2 * (surveyed++ % (survey.size() / 2));
        target = {survey[at], survey[at + 1]};
        enter(State::Survey);
    }

    /// Whether something is near a sonar that looks between two bearings, positive to the left.
    [[nodiscard]] bool isNear(double low, double high) const {
        for (std::size_t i = 0; i < sonars.size(); ++i)
            if (sonarBearings[i] >= low && sonarBearings[i] <= high && sonars[i].time() >= 0 && sonars[i].range() < clearance)
                return true;
        return false;
    }

    /// Drives and turns; where its back would swing into something, it goes past that first.
    void steer(const ScanPoints& scan, double linear, double turn, Point ignored, double ignoredRadius) {
        const bool swings = turn > 0.1    ? isNear(-160 * kDegree, -80 * kDegree)
                            : turn < -0.1 ? isNear(80 * kDegree, 160 * kDegree)
                                          : false;
        if (!swings || !scan.isFree(0, 0.6, kLane, ignored, ignoredRadius)) return drive.move(linear, turn);
        drive.move(std::max(linear, kPass), std::clamp(turn, -0.1, 0.1));
    }

    /// Drives towards `target` around what is in the way. True: nearer than `stop` m.
    bool driveTo(const ScanPoints& scan, double stop, Point ignored, double ignoredRadius) {
        const Point to = inside(target);
        const double far = to.range();
        if (far < stop) {
            drive.stop();
            return true;
        }
        const double bearing = scan.freeBearing(to.bearing(), std::min(far, 1.0), kLane, ignored, ignoredRadius);
        const double turn = std::clamp(2 * bearing, -turnRate, turnRate);
        const double most = std::min(speed, 0.1 + 0.8 * (far - stop));
        steer(scan, std::abs(bearing) > 30 * kDegree ? 0 : most * std::cos(2 * bearing), turn, ignored, ignoredRadius);
        return false;
    }

    void driveToSurvey(const ScanPoints& scan) {
        if (driveTo(scan, 0.15, {}, 0) || elapsed() > 60) enter(State::Search);
    }

    /// To where it can grip the target, and turned to it.
    void approach(const ScanPoints& scan) {
        if (const auto seen = nearest(scan, target, kSameThing)) target = *seen;
        if (elapsed() > 60) return enter(State::Search);
        if (!driveTo(scan, kAlign, inside(target), 0.15)) return;
        const double bearing = inside(target).bearing();
        if (std::abs(bearing) > 1 * kDegree) return drive.move(0, std::clamp(1.5 * bearing, -turnRate, turnRate));
        enter(State::Reach);
    }

    /// Straight to it, until it is between the jaws.
    void reach(const ScanPoints& scan) {
        if (const auto seen = nearest(scan, target, 0.1)) target = *seen;
        const Point to = inside(target);
        if (to.x > grip) return drive.move(std::clamp(to.x - grip, 0.03, 0.12), 2 * to.bearing());
        drive.stop();
        gripper.setOpening(-1);
        enter(State::Close);
    }

    void close() {
        if (gripper.holding()) {
            lift.setTarget(0.05);
            if (lift.position() > 0.045) enter(State::Carry);
        } else if (elapsed() > 8) {
            print("gripped nothing");
            release();
        }
    }

    void release() {
        gripper.setOpening(0);
        lift.setTarget(0);
        enter(State::Open);
    }

    /// To a place before its slot in the row, there turned to it, and to the slot.
    void carry(const ScanPoints& scan) {
        if (gripper.position() < -0.18) {
            print("lost it");
            return release();
        }
        const Point to = slot();
        target = {to.x + grip + kRetreat, to.y};
        if (row == 0 && !driveTo(scan, 0.08, {grip, 0}, 0.12)) return;
        if (row == 0) row = 1;
        const double off = wrapped(kPi - here.heading), aside = here.y - to.y;
        if (row == 1 && std::abs(off) > 1 * kDegree) return drive.move(0, std::clamp(1.5 * off, -turnRate, turnRate));
        row = 2;
        if (here.x > to.x + grip)
            return drive.move(std::clamp(here.x - to.x - grip, 0.04, 0.2), 1.5 * (off + std::clamp(1.5 * aside, -0.4, 0.4)));
        drive.stop();
        lift.setTarget(0);
        enter(State::PutDown);
    }

    void putDown() {
        if (lift.position() > 0.002 && elapsed() < 8) return;
        gripper.setOpening(0);
        delivered.set(delivered.get() + 1);
        print("brought ", delivered.get(), " of ", count);
        enter(State::Open);
    }

    void open() {
        if (gripper.position() > -0.01 || elapsed() > 8) enter(State::Retreat);
    }

    void retreat() {
        const double gone = collect::length(here.x - from.x, here.y - from.y);
        const bool blocked = gone > kReleased && (isNear(120 * kDegree, 180 * kDegree) || isNear(-180 * kDegree, -120 * kDegree));
        if (gone < kRetreat && !blocked && elapsed() < 10) return drive.move(-0.25, 0);
        drive.stop();
        if (delivered.get() >= count) return finish("all are home");
        enter(State::Search);
    }

    trundle::LidarPort lidar;
    std::vector<trundle::RangePort> sonars;
    trundle::GripperPort gripper;
    trundle::LinearMotorPort lift;
    trundle::DifferentialDrivePort drive;
    State state = State::Search;
    double since = 0;                   ///< s, when this state began
    trundle::Pose2 here, from;          ///< now, and when this state began
    double turned = 0, lastHeading = 0; ///< rad, in this state
    Point target;                       ///< in the odometry's frame
    std::optional<Point> best;          ///< nearest cylinder seen in this turn
    double bestFar = 0;                 ///< m
    std::size_t surveyed = 0;
    int row = 0; ///< 0: on the way to the row, 1: turns to it, 2: drives into it
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<Collect>("Collect"); }
