#include "project/wizard/arena_text.h"

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace trundle {
namespace {

constexpr const char* kFloorLine = "Plane floor { Material=concrete Surface=ground }\n";
constexpr double kWall = 0.1, kHigh = 0.4; // m

__attribute__((format(printf, 1, 2))) std::string arenaLine(const char* format, ...) {
    char text[500];
    va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

/// To the tenth of a millimetre, and never "-0".
double tidy(double metres) { return std::round(metres * 1e4) / 1e4 + 0.0; }

std::string arenaHead(const std::string& comment, const std::string& name, double height) {
    return "// " + comment + "\n#import common/materials.sim\n#import common/surfaces.sim\n\nStaticConfig " + name + " {\n" +
           arenaLine("  Param height = %.6g   // m, of the walls\n\n", tidy(height)) + "  " + kFloorLine;
}

/// A wall by its middle and its sides along x and y.
std::string wallLine(const std::string& name, double x, double y, double along, double across) {
    return arenaLine("  Box %s { Pos=%.6g,%.6g,$(height/2) Size=%.6g,%.6g,$height Material=wood Surface=wall }\n", name.c_str(),
                     tidy(x), tidy(y), tidy(along), tidy(across));
}

/// "room" of the config Room.
std::string objectName(std::string config) {
    config[0] = static_cast<char>(config[0] - 'A' + 'a');
    return config;
}

} // namespace

std::string arenaText(const std::string& name, const FloorPlan& plan, double height, const std::string& source) {
    std::string text = arenaHead(arenaLine("%s: %.4g m x %.4g m, from the floor plan %s. Its middle is the origin.", name.c_str(),
                                           plan.columns * plan.cell, plan.rows * plan.cell, source.c_str()),
                                 name, height);
    int number = 0;
    for (const PlanBox& wall : plan.walls)
        text +=
            wallLine("wall" + std::to_string(++number), (wall.x + wall.width / 2. - plan.columns / 2.) * plan.cell,
                     (plan.rows / 2. - wall.y - wall.height / 2.) * plan.cell, wall.width * plan.cell, wall.height * plan.cell);
    return text + "}\n";
}

Result<std::string> obstacleText(const std::string& name, const ObstacleField& f) {
    const Result<std::vector<FieldObstacle>> obstacles = obstacleField(f);
    if (!obstacles) return obstacles.error();
    std::string text =
        arenaHead(arenaLine("%s: a room, %.4g m x %.4g m inside, with %d obstacles of the seed %llu. Its middle is "
                            "the origin, and free.",
                            name.c_str(), f.length, f.width, f.count, static_cast<unsigned long long>(f.seed)),
                  name, kHigh);
    const double x = f.length / 2 + kWall / 2, y = f.width / 2 + kWall / 2;
    text += wallLine("north", 0, y, f.length + 2 * kWall, kWall) + wallLine("south", 0, -y, f.length + 2 * kWall, kWall) +
            wallLine("east", x, 0, kWall, f.width) + wallLine("west", -x, 0, kWall, f.width) + "\n";
    for (const FieldObstacle& obstacle : obstacles.value()) text += "  " + obstacleLine(obstacle);
    return text + "}\n";
}

std::string obstacleBlocksText(const std::string& name, const std::vector<FieldObstacle>& obstacles, bool hasFloor) {
    std::string text = "StaticConfig " + name + " {\n";
    if (hasFloor) text += std::string("  ") + kFloorLine;
    for (const FieldObstacle& obstacle : obstacles) text += "  " + obstacleLine(obstacle);
    return text + "}\nStatic " + objectName(name) + " { Config=" + name + " }\n";
}

std::string obstacleGeomsText(const std::vector<FieldObstacle>& obstacles, bool hasFloor) {
    std::string text = hasFloor ? kFloorLine : "";
    for (const FieldObstacle& obstacle : obstacles) text += obstacleLine(obstacle);
    return text;
}

std::string roomText(const std::string& name, const RoomPlan& plan, const std::string& comment) {
    std::string text = arenaHead(comment, name, plan.height);
    for (const RoomWall& w : plan.walls) text += wallLine(w.name, w.x, w.y, w.along, w.across);
    return text + "}\n";
}

std::string roomBlocksText(const std::string& name, const RoomPlan& plan, bool hasFloor, const std::array<double, 2>& place) {
    std::string text =
        "StaticConfig " + name + " {\n" + arenaLine("  Param height = %.6g   // m, of the walls\n\n", tidy(plan.height));
    if (hasFloor) text += std::string("  ") + kFloorLine;
    for (const RoomWall& w : plan.walls) text += wallLine(w.name, w.x, w.y, w.along, w.across);
    text += "}\nStatic " + objectName(name) + " { Config=" + name;
    if (tidy(place[0]) != 0 || tidy(place[1]) != 0) text += arenaLine(" Pos=%.6g,%.6g,0", tidy(place[0]), tidy(place[1]));
    return text + " }\n";
}

std::string roomBoxesText(const RoomPlan& plan, bool hasFloor, const std::array<double, 2>& place) {
    std::string text = hasFloor ? kFloorLine : "";
    for (const RoomWall& w : plan.walls)
        text += arenaLine("Box %s { Pos=%.6g,%.6g,%.6g Size=%.6g,%.6g,%.6g Material=wood Surface=wall }\n", w.name.c_str(),
                          tidy(w.x + place[0]), tidy(w.y + place[1]), tidy(plan.height / 2), tidy(w.along), tidy(w.across),
                          tidy(plan.height));
    return text;
}

std::string arenaExperimentText(const std::string& name, const std::string& file, const std::array<double, 2>& place,
                                double across, double floor) {
    const double far = std::max(1.5, across);
    return "// " + name + ", with a robot to drive through it: Run, then Drive with the Keyboard.\nTick = 0.01\n#import " + file +
           ".sim\n#import robots/simple_robot.sim\n\nStatic arena { Config=" + name + " }\n" +
           arenaLine("Robot robot0 { Config=SimpleRobot Pos=%.4g,%.4g,%.4g }\n", tidy(place[0]), tidy(place[1]), tidy(floor)) +
           arenaLine("View overview { Eye=%.3g,%.3g,%.3g Target=0,0,0 }\n", -0.1 * far, -0.7 * far, 0.9 * far);
}

} // namespace trundle
