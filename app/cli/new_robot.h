#pragma once
// `trundle-cli new robot`: the dimensions as options, and what is printed.

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "cli/exit_code.h"

namespace trundle {

/// What is not given is as usual for the base.
struct RobotArguments {
    std::string base = "differential";
    std::optional<double> length, width, height, wheelRadius, wheelSeparation, wheelBase, mass, topSpeed;
};

void addRobotOptions(CLI::App& command, RobotArguments& arguments);
[[nodiscard]] ExitCode makeNewRobot(const RobotArguments& arguments, const std::string& name, const std::string& parent);

} // namespace trundle
