#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "project/wizard/robot_text.h"

namespace trundle {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kSteering = 25 * kPi / 180; // rad, of the tightest corner
constexpr double kTurnShare = 0.8;           // of the top speed, by the wheels in a turn
constexpr double kRamp = 1;                  // m/s^2, as a base does

std::string number(double value) {
    char text[40];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}
std::string decimal(double value) {
    const std::string text = number(value);
    return text.find('.') == std::string::npos ? text + ".0" : text;
}

constexpr const char* kTurning = R"(
    turn_rate = field("TurnRate", @TURN@, radians_per_second().within(0.01, 10), "At its corners.")

    def setup(self, robot):
        self.drive = robot.@PORT@("base")
        self.steps = 0  # sides and corners that it has begun

    def update(self, since_last):
        if not self.drive.done() or self.steps == 8:
            return  # on its way, or back at the start: what comes next is yours
        if self.steps % 2 == 0:
            self.drive.drive(self.speed, 0.0, self.side, 0.0)  # m/s, rad/s, m, rad
        else:
            self.drive.turn(self.turn_rate, math.pi / 2)  # a positive angle turns left
        self.steps += 1
)";

constexpr const char* kHolonomic = R"(
    def setup(self, robot):
        self.drive = robot.@PORT@("base")
        self.steps = 0  # sides that it has begun

    def update(self, since_last):
        if not self.drive.done() or self.steps == 4:
            return  # on its way, or back at the start: what comes next is yours
        direction = self.steps * math.pi / 2  # ahead, left, back, right; it does not turn
        ahead, left = self.speed * math.cos(direction), self.speed * math.sin(direction)
        self.drive.drive(ahead, left, 0.0, self.side, 0.0)  # m/s, m/s, rad/s, m, rad
        self.steps += 1
)";

constexpr const char* kSteered = R"(
    radius = field("Radius", @RADIUS@, metres().within(0.01, 100), "Of its corners.")

    def setup(self, robot):
        self.drive = robot.@PORT@("base")
        self.corner = math.atan(@WHEELBASE@ / self.radius)  # rad: the wheelbase by the radius
        self.steps = 0  # sides and corners that it has begun

    def update(self, since_last):
        if not self.drive.done() or self.steps == 8:
            return  # on its way, or back at the start: what comes next is yours
        angle = self.corner if self.steps % 2 else 0.0  # a positive angle steers left
        if abs(self.drive.steering() - angle) > 0.001:
            return self.drive.move(0.0, angle)  # it steers first and drives then
        way = self.radius * math.pi / 2 if self.steps % 2 else self.side - 2 * self.radius
        self.drive.drive(self.speed, angle, way)  # m/s, rad, m
        self.steps += 1
)";

const char* portName(BaseShape base) {
    switch (base) {
    case BaseShape::Differential: return "differential_drive";
    case BaseShape::SkidSteer: return "skid_drive";
    case BaseShape::Omni: return "omni_drive";
    case BaseShape::Mecanum: return "mecanum_drive";
    case BaseShape::Ackermann: break;
    }
    return "ackermann_drive";
}

bool isHolonomic(BaseShape base) { return base == BaseShape::Omni || base == BaseShape::Mecanum; }
bool turnsOnTheSpot(BaseShape base) { return base == BaseShape::Differential || base == BaseShape::SkidSteer; }

std::string with(std::string text, const std::string& from, const std::string& to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
    return text;
}

/// "rover" for Rover, "robot0" where that is a reserved word or the name of something else in the experiment.
std::string robotNameFor(const std::string& config) {
    std::string name = config;
    name[0] = static_cast<char>(name[0] >= 'A' && name[0] <= 'Z' ? name[0] - 'A' + 'a' : name[0]);
    constexpr const char* kUsed[] = {"floor", "overview", "path", "world", "true", "false"};
    return std::ranges::find(kUsed, name) == std::end(kUsed) ? name : "robot0";
}

/// s: all sides and corners, with their ramps, and a moment at the end.
double duration(const SquareDrive& square, BaseShape base) {
    const double ramp = square.speed / kRamp;
    double seconds = 4 * (square.side / square.speed + ramp);
    if (turnsOnTheSpot(base)) seconds += 4 * (kPi / 2 / square.turnRate + square.turnRate / 4);
    if (square.radius > 0) seconds += 4 * (ramp + 1); // it steers
    return std::ceil(seconds + 2);
}

} // namespace

SquareDrive squareDrive(const RobotDesign& d) {
    SquareDrive square;
    square.speed = std::min(0.3, d.topSpeed);
    square.turnRate = std::min(1., 0.5 * square.speed / (d.wheelSeparation / 2));
    square.turnRate = std::min(square.turnRate, kTurnShare * d.topSpeed / (d.wheelSeparation / 2 * skidFactor(d)));
    square.turnRate = std::max(0.02, std::floor(square.turnRate * 50) / 50);
    if (d.base != BaseShape::Ackermann) return square;
    square.radius = std::ceil(d.wheelBase / std::tan(kSteering) * 20) / 20;
    square.side = std::max(1., std::ceil(2.5 * square.radius));
    return square;
}

std::string squareExperimentText(const RobotDesign& d, const std::string& file) {
    const SquareDrive square = squareDrive(d);
    const std::string robot = robotNameFor(d.name);
    const double far = std::max(1.5, square.side * 1.6), middle = square.side / 2;
    return "// " + d.name + " drives a square of " + number(square.side) + " m" +
           (square.radius > 0 ? " with round corners" : "") + ", by its odometry. Another one: `--set " + robot +
           ".brain.Side=" + number(2 * square.side) + "`.\nTick = 0.005   Duration = " + number(duration(square, d.base)) +
           "\n#import " + file + ".sim\n#import arenas/open_floor.sim\n#loadModule " + file +
           "_square.py\n\nStatic floor { Config=OpenFloor }\nRobot " + robot + " {\n  Config=" + d.name + "\n  " + d.name +
           "Square brain { }\n}\nView overview { Eye=" + number(-far / 2) + ',' + number(-far / 2) + ',' + number(far) +
           " Target=" + number(middle) + ',' + number(middle) + ",0 }\nPoseLog path { Robot=" + robot +
           " Interval=0.05 File=" + file + "_square.csv }\n";
}

std::string squareControllerText(const RobotDesign& d, const std::string& file) {
    const SquareDrive square = squareDrive(d);
    const bool turns = turnsOnTheSpot(d.base);
    std::string text =
        "# Drives " + d.name +
        " along a square, by its odometry: a start for a controller of your own. An experiment uses it with\n"
        "#\n#     #loadModule " +
        file + "_square.py\n#     Robot robot0 { Config=" + d.name + "  " + d.name +
        "Square brain { Side = 1 } }\n#\n# Change what it does in `update`. The guide says what a controller can do besides: "
        "sensors, cameras, radios.\nimport math\n\nimport trundle\nfrom trundle import field, metres, metres_per_second" +
        (turns ? ", radians_per_second" : "") + "\n\n\nclass " + d.name +
        "Square(trundle.Controller):\n    \"\"\"Drives a square" + (square.radius > 0 ? " with round corners" : "") +
        " to the left and stops where it began.\"\"\"\n\n" + "    side = field(\"Side\", " + decimal(square.side) +
        ", metres().within(0.1, 100), \"Of the square.\")\n" + "    speed = field(\"Speed\", " + decimal(square.speed) +
        ", metres_per_second().within(0.001, " + number(d.topSpeed) + "), \"Along it, at most the top speed.\")";
    text += turns ? kTurning : isHolonomic(d.base) ? std::string("\n") + kHolonomic : kSteered;
    text = with(std::move(text), "@PORT@", portName(d.base));
    text = with(std::move(text), "@TURN@", decimal(square.turnRate));
    text = with(std::move(text), "@RADIUS@", decimal(square.radius));
    return with(std::move(text), "@WHEELBASE@", decimal(d.wheelBase));
}

} // namespace trundle
