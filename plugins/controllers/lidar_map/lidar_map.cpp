// Explores a place and draws its map, from the ranges of a level lidar and the odometry of its wheels alone.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <trundle/controller.h>

#include "frontier_planner.h"

using lidar_map::Cell, lidar_map::FrontierPlanner, lidar_map::OccupancyGrid;

namespace {

constexpr double kDegree = std::numbers::pi / 180;
constexpr double kLookAhead = 0.15; // m along its path: where it heads
constexpr int kScansPerPlan = 5;
constexpr double kLongest = 60; // s without anything new: what is left cannot be seen

struct LidarMap : trundle::Controller {
    double cellSize = 0.05;
    double side = 14;
    double speed = 0.15;
    double turnRate = 1.2;
    double clearance = 0.25;
    double usedRange = 2.5;
    double deviation = 0.004, deviationPerMetre = 0.0175;
    double lidarAhead = -0.032;
    double fieldOfView = 360 * kDegree;
    std::string file = "map.pgm", lidarName = "scan", driveName = "base";
    trundle::OutputSlot<double> known;

    static void describe(trundle::Describe<LidarMap>& d) {
        using C = LidarMap;
        d.help(
            "Drives to where its map ends until all that it can reach is known, saves the map as a picture, and ends the run.");
        d.field("CellSize", &C::cellSize, trundle::metres().within(0.005, 1), "Side of a cell of the map.");
        d.field("Side", &C::side, trundle::metres().within(1, 200), "Of the whole map; it begins in the middle.");
        d.field("Speed", &C::speed, trundle::metresPerSecond().above(0).atMost(10).live(), "At most.");
        d.field("TurnRate", &C::turnRate, trundle::radiansPerSecond().above(0).atMost(100).live(), "At most.");
        d.field("Clearance", &C::clearance, trundle::metres().within(0, 10), "From its axle to what is in the map.");
        d.field("UsedRange", &C::usedRange, trundle::metres().above(0).atMost(1000),
                "What is farther from the lidar does not get into the map.");
        d.field("Deviation", &C::deviation, trundle::metres().within(0, 10), "Noise of the lidar.");
        d.field("DeviationPerMetre", &C::deviationPerMetre, trundle::number().within(0, 10), "Its NoisePerMetre.");
        d.field("LidarAhead", &C::lidarAhead, trundle::metres().within(-10, 10), "From the axle to the lidar.");
        d.field("FieldOfView", &C::fieldOfView, trundle::degrees().above(0).atMost(360), "That of the lidar.");
        d.field("File", &C::file, trundle::text(), "Of the map, in the log folder; with a .yaml beside it that ROS reads.");
        d.field("Lidar", &C::lidarName, trundle::needs("Lidar"), "The robot's Lidar.");
        d.field("Drive", &C::driveName, trundle::needs("DifferentialDrive"), "The robot's DifferentialDrive.");
        d.output("known", &C::known, "m^2", "Area of the cells that are free or occupied.");
    }

    void setup(trundle::RobotPorts& robot) override {
        lidar = robot.lidar(lidarName);
        drive = robot.differentialDrive(driveName);
        map.emplace(side, cellSize);
    }

    void update(trundle::Seconds) override {
        if (!lidar.fresh()) return; // a scan, not a tick, is its step
        here = drive.odometry();
        addScan();
        if (scans++ % kScansPerPlan == 0) {
            if (map->knownArea() > known.get() + 0.01) grown = time();
            known.set(map->knownArea());
            if (time() - grown > kLongest) return save();
            const auto next = FrontierPlanner(*map, clearance).path(map->cellAt(here.x, here.y));
            if (!next) return save();
            path = *next;
        }
        follow();
    }

private:
    void addScan() {
        const auto ranges = lidar.ranges();
        const double x = here.x + lidarAhead * std::cos(here.heading), y = here.y + lidarAhead * std::sin(here.heading);
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            const bool isHit = ranges[i] < usedRange;
            map->addBeam(x, y, here.heading - fieldOfView / 2 + static_cast<double>(i) * beamStep(),
                         std::min(ranges[i], usedRange), isHit, deviation + deviationPerMetre * ranges[i]);
        }
    }

    /// Heads for the cell of its path that is farthest within kLookAhead.
    void follow() {
        Cell goal = path.empty() ? map->cellAt(here.x, here.y) : path.front();
        for (const Cell c : path)
            if (distance(c) < kLookAhead) goal = c;
        const double way = std::atan2(map->middle(goal.y) - here.y, map->middle(goal.x) - here.x);
        const double error = std::remainder(way - here.heading, 2 * std::numbers::pi);
        const double turn = std::clamp(2 * error, -turnRate, turnRate);
        if (isBlocked()) return drive.move(-0.3 * speed, turn); // its map is wrong here
        drive.move(std::abs(error) > 40 * kDegree ? 0 : speed * std::cos(error), turn);
    }
    /// Something is ahead of it, nearer than half of its clearance.
    [[nodiscard]] bool isBlocked() const {
        const auto ranges = lidar.ranges();
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            const double bearing = -fieldOfView / 2 + static_cast<double>(i) * beamStep();
            if (std::abs(bearing) < 35 * kDegree && ranges[i] + lidarAhead < clearance / 2) return true;
        }
        return false;
    }
    /// rad between two beams.
    [[nodiscard]] double beamStep() const {
        const bool closed = fieldOfView > 359.9 * kDegree;
        return fieldOfView / static_cast<double>(std::max<std::size_t>(1, lidar.ranges().size() - (closed ? 0 : 1)));
    }
    [[nodiscard]] double distance(Cell c) const {
        const double x = map->middle(c.x) - here.x, y = map->middle(c.y) - here.y;
        return std::sqrt(x * x + y * y);
    }

    void save() {
        drive.stop();
        if (trundle::Log picture = openLog(file); picture.open()) {
            picture.write(map->picture());
            const std::string stem = file.substr(0, file.rfind('.'));
            openLog(stem + ".yaml").write(map->pictureDescription(file.substr(file.rfind('/') + 1)));
            print("mapped ", known.get(), " m^2 into ", file);
        } else warn("there is no log folder for ", file);
        finish("mapped");
    }

    trundle::LidarPort lidar;
    trundle::DifferentialDrivePort drive;
    std::optional<OccupancyGrid> map;
    trundle::Pose2 here;
    std::vector<Cell> path;
    long scans = 0;
    double grown = 0; ///< s: when its map last became larger
};

} // namespace

TRUNDLE_MODULE(registry) { registry.controller<LidarMap>("LidarMap"); }
