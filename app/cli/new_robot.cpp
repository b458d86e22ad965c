#include "cli/new_robot.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <utility>

#include "app/robot_files.h"
#include "base/clean_text.h"
#include "cli/messages.h"
#include "cli/standard_streams.h"

namespace trundle {
namespace {

constexpr std::pair<const char*, BaseShape> kBases[] = {{"differential", BaseShape::Differential},
                                                        {"skid-steer", BaseShape::SkidSteer},
                                                        {"omni", BaseShape::Omni},
                                                        {"mecanum", BaseShape::Mecanum},
                                                        {"ackermann", BaseShape::Ackermann}};

RobotDesign designOf(const RobotArguments& a, const std::string& name) {
    const auto* base = std::ranges::find(kBases, a.base, &std::pair<const char*, BaseShape>::first);
    RobotDesign d = usualDesign(base->second);
    d.name = name;
    for (const auto& [to, given] : {std::pair{&d.length, a.length},
                                    {&d.width, a.width},
                                    {&d.height, a.height},
                                    {&d.wheelRadius, a.wheelRadius},
                                    {&d.wheelSeparation, a.wheelSeparation},
                                    {&d.wheelBase, a.wheelBase},
                                    {&d.mass, a.mass},
                                    {&d.topSpeed, a.topSpeed}})
        if (given) *to = *given;
    placeWheels(d, !a.wheelSeparation, !a.wheelBase);
    return d;
}

} // namespace

void addRobotOptions(CLI::App& command, RobotArguments& a) {
    std::vector<std::string> names;
    for (const auto& [name, base] : kBases) names.emplace_back(name);
    const auto add = [&](const char* name, auto& to, const char* help, const char* type) {
        return command.add_option(name, to, help)
            ->type_name(type)
            ->group("Of a robot; what is not given is as usual for its base");
    };
    add("--base", a.base, "differential (the default), skid-steer, omni with three wheels, mecanum, or ackermann", "BASE")
        ->check(CLI::IsMember(names));
    add("--length", a.length, "Of the hull", "M");
    add("--width", a.width, "Of the hull; of an omni base, its diameter", "M");
    add("--height", a.height, "Of the hull", "M");
    add("--wheel-radius", a.wheelRadius, "Of all wheels", "M");
    add("--wheel-separation", a.wheelSeparation, "From left to right; of an omni base, the diameter of the circle of its wheels",
        "M");
    add("--wheelbase", a.wheelBase, "Between the axles", "M");
    add("--mass", a.mass, "Of the whole robot", "KG");
    add("--top-speed", a.topSpeed, "To be reached with a reserve of 20 %", "M/S");
}

ExitCode makeNewRobot(const RobotArguments& arguments, const std::string& name, const std::string& parent) {
    if (arguments.wheelBase && (arguments.base == "differential" || arguments.base == "omni")) {
        printProblem("--wheelbase: a base that is " + arguments.base + " has no two axles; skid-steer, mecanum and ackermann have");
        return kExitUsage;
    }
    const Result<NewRobot> made = makeRobot(designOf(arguments, name), parent);
    if (!made) {
        printProblem(made.error().message);
        return kExitUsage;
    }
    const NewRobot& robot = made.value();
    std::string text = "wrote";
    for (const std::string& file : robot.files) text += ' ' + cleanLine(robot.folder) + '/' + file;
    char reached[160];
    std::snprintf(reached, sizeof reached, ": %.2f m/s with a reserve of 20 %%, slopes of up to %.0f degrees",
                  robot.choice.topSpeed, std::floor(robot.choice.slope * 180 / std::numbers::pi));
    text += "\nmotors: " + std::string(robot.choice.motor.name) + reached +
            "\n\nTo drive a square with it:\n  trundle-cli run --trust " + cleanLine(robot.experiment) + "\n";
    return writeOut(text) ? kExitDone : kExitText;
}

} // namespace trundle
