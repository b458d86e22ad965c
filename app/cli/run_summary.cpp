#include <algorithm>
#include <cmath>
#include <cstdio>
#include <span>

#include "base/clean_text.h"
#include "cli/messages.h"
#include "cli/numbers.h"
#include "cli/run_report.h"
#include "model/passive_objects.h"

namespace trundle {
namespace {

constexpr double kDegrees = 57.29577951308232;
constexpr std::size_t kMaxListed = 8; // a larger number of robots is summarised

std::string row(const std::string& name, const std::string& text) {
    constexpr std::size_t kNameWidth = 12;
    return name + std::string(name.size() < kNameWidth ? kNameWidth - name.size() : 1, ' ') + text + "\n";
}

std::string poseText(const Pose& pose) {
    const Vec3 hpr = hprFromRotation(pose.rotation) * kDegrees;
    std::string text = "at x " + fixedText(pose.position.x(), 4) + " m, y " + fixedText(pose.position.y(), 4) + " m, z " +
                       fixedText(pose.position.z(), 4) + " m, heading " + fixedText(hpr.x(), 3) + " deg";
    // Pitch and roll are shown only if the robot is tilted.
    if (std::fabs(hpr.y()) > 0.5 || std::fabs(hpr.z()) > 0.5)
        text += ", pitch " + fixedText(hpr.y(), 2) + " deg, roll " + fixedText(hpr.z(), 2) + " deg";
    return text;
}

/// "1.000021 m of 1 m commanded (+0.021 mm)"
std::string driveText(double driven, double commanded, const char* unit, double errorScale, const char* errorUnit) {
    const double error = (driven - commanded) * errorScale;
    return fixedText(driven, 6) + " " + unit + " of " + shortText(commanded, 6) + " " + unit + " commanded (" +
           (error >= 0 ? "+" : "") + fixedText(error, 4) + " " + errorUnit + ")";
}

std::string driveRows(const DriveTotals& drive) {
    std::string text;
    if (drive.commandedDistance != 0 || std::fabs(drive.drivenDistance) > 1e-3)
        text += row("", "drove  " + driveText(drive.drivenDistance, drive.commandedDistance, "m", 1000, "mm"));
    if (drive.commandedAngle != 0 || std::fabs(drive.drivenAngle) > 1e-3)
        text += row("", "turned " + driveText(drive.drivenAngle * kDegrees, drive.commandedAngle * kDegrees, "deg", 1, "deg"));
    if (drive.underWay) text += row("", "the last command was still under way");
    return text;
}

/// Many drives in one row: how many had commanded amounts, and the largest errors.
std::string worstDriveRow(const std::vector<DriveTotals>& drives, const std::vector<RobotSpec>& robots) {
    if (drives.empty()) return {};
    const auto distanceError = [](const DriveTotals& d) { return std::fabs(d.distanceError); };
    const auto angleError = [](const DriveTotals& d) { return std::fabs(d.angleError); };
    const DriveTotals& distance = *std::ranges::max_element(drives, {}, distanceError);
    const DriveTotals& angle = *std::ranges::max_element(drives, {}, angleError);
    const auto underWay = static_cast<std::size_t>(std::ranges::count(drives, true, &DriveTotals::underWay));
    const auto ended = std::ranges::count_if(drives, [](const DriveTotals& d) { return d.ended > 0; });
    const std::string off = "at most " + fixedText(distanceError(distance) * 1000, 4) + " mm off (" +
                            robots[distance.robot].name + "), " + fixedText(angleError(angle) * kDegrees, 4) + " deg off (" +
                            robots[angle.robot].name + ") in the amounts that ran to their end";
    std::string text = row("", counted(drives.size(), "drive") +
                                   " with commanded amounts: " + (ended > 0 ? off : "none has run to its end yet"));
    if (underWay > 0) text += row("", "the last command of " + std::to_string(underWay) + " was still under way");
    return text;
}

/// "2 robots, 5 objects".
std::string worldText(const ExperimentSpec& experiment) {
    const RobotCounts counts = countRobots(experiment);
    if (counts.objects == 0) return counted(counts.robots, "robot");
    return (counts.robots > 0 ? counted(counts.robots, "robot") + ", " : "") + counted(counts.objects, "object");
}

std::string robotRows(const RunReport& report, const World& world) {
    const std::vector<RobotSpec>& all = world.experiment().robots;
    const auto scenery = std::ranges::find_if(all, [](const RobotSpec& robot) { return robot.scenery != nullptr; });
    const std::span robots(all.begin(), scenery); // what moves in Statics comes last
    const bool hasObjects = std::ranges::any_of(robots, [](const RobotSpec& robot) { return isPassive(robot); });
    std::string text = hasObjects && robots.size() <= kMaxListed ? row("world", worldText(world.experiment())) : "";
    for (std::size_t i = 0; i < robots.size() && robots.size() <= kMaxListed; ++i) {
        text += row(robots[i].name, poseText(world.reportedPose(i)));
        for (const DriveTotals& drive : report.drives)
            if (drive.robot == i) text += driveRows(drive);
    }
    if (robots.size() <= kMaxListed) return text;

    Vec3 low = world.robotPose(0).position, high = low;
    double farthest = 0;
    for (std::size_t i = 0; i < robots.size(); ++i) {
        const Vec3 position = world.robotPose(i).position;
        low = low.cwiseMin(position);
        high = high.cwiseMax(position);
        farthest = std::max(farthest, (position - robots[i].pose.position).norm());
    }
    return row("robots", worldText(world.experiment()) + " between x " + fixedText(low.x(), 2) + " and " +
                             fixedText(high.x(), 2) + " m, y " + fixedText(low.y(), 2) + " and " + fixedText(high.y(), 2) +
                             " m; the farthest " + fixedText(farthest, 2) + " m from its start") +
           worstDriveRow(report.drives, all);
}

std::string endRows(const World& world) {
    std::string text;
    const auto& ends = world.robotFaults().ends;
    for (std::size_t i = 0; i < ends.size() && i < kMaxListed; ++i)
        text += row(i == 0 ? "ended" : "", ends[i].fault.body + " at t = " + shortText(ends[i].fault.time, 9) +
                                               " s: " + cleanLine(ends[i].fault.reason));
    if (ends.size() > kMaxListed) text += row("", "and " + std::to_string(ends.size() - kMaxListed) + " more");
    return text;
}

std::string stoppedRows(const Runner& runner, const ExperimentSpec& experiment) {
    std::string text;
    const auto& stopped = runner.stoppedControllers();
    for (std::size_t i = 0; i < stopped.size() && i < kMaxListed; ++i) {
        const RobotSpec& robot = experiment.robots[stopped[i].robot];
        text += row(i == 0 ? "stopped" : "", robot.name + "/" + stopped[i].controller + " at t = " +
                                                 shortText(stopped[i].time, 9) + " s: " + cleanLine(stopped[i].fault.reason));
    }
    if (stopped.size() > kMaxListed) text += row("", "and " + std::to_string(stopped.size() - kMaxListed) + " more");
    return text;
}

std::string solverRows(const World& world) {
    std::string text;
    const EngineChoice engine = world.experiment().settings.engine;
    const unsigned count = threadsFor(world.experiment());
    const std::string threads = count > 1 ? std::to_string(count) + " threads" : "";
    const std::string& reason = world.experiment().settings.whyGeneral;
    if (engine != EngineChoice::General || !reason.empty()) {
        text += row("engine", nameOf(engine) + (threads.empty() ? "" : ", " + threads));
        if (!reason.empty()) text += row("", "not wheeled: " + cleanLine(reason));
    } else if (!threads.empty()) text += row("engine", threads);
    const bool asked = world.experiment().settings.solver == SolverChoice::Quick;
    if (world.solves().quickTicks > 0)
        text += row("solver", counted(world.solves().quickTicks, "tick") + " solved by the quick solver (" +
                                  (asked ? "Solver = quick" : "piles of more than 60 contacts") +
                                  (world.solves().rescuedTicks > 0 ? ", or the exact one could not" : "") + ")");
    if (world.solves().rescuedTicks > 0)
        text += row(world.solves().quickTicks == 0 ? "solver" : "",
                    counted(world.solves().rescuedTicks, "tick") + " repeated with softer constraints (the exact solver failed)");
    return text;
}

std::string logRows(const std::vector<std::string>& files) {
    std::string text;
    for (std::size_t i = 0; i < files.size() && i < kMaxListed; ++i) text += row(i == 0 ? "logs" : "", cleanLine(files[i]));
    if (files.size() > kMaxListed)
        text += row("", "and " + std::to_string(files.size() - kMaxListed) + " more in the same folder");
    return text;
}

} // namespace

std::string hashText(std::uint64_t hash) {
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
    return text;
}

std::string runSummary(const RunReport& report) {
    const World& world = report.runner->world();
    const double simulated = world.time();
    std::string text = row("experiment", cleanLine(report.name) + (report.interrupted         ? ", interrupted"
                                                                   : report.runner->failure() ? ", stopped by an error"
                                                                                              : ""));
    text += row("simulated", shortText(simulated, 9) + " s in " + counted(world.ticks(), "tick") + " of " +
                                 exactText(world.experiment().settings.tick) + " s");
    if (const RunFinish* finish = report.runner->finished())
        text += row("finished", "by " + cleanLine(finish->robot + "/" + finish->controller) +
                                    " at t = " + shortText(finish->time, 9) + " s" + (finish->reason.empty() ? "" : ": ") +
                                    cleanLine(finish->reason));
    if (world.ticks() > 0 && report.wallS > 0)
        text += row("took", shortText(report.wallS) + " s, " + shortText(simulated / report.wallS) + " x real time");
    if (!world.experiment().robots.empty()) text += robotRows(report, world);
    text += endRows(world);
    text += stoppedRows(*report.runner, world.experiment());
    text += solverRows(world);
    text += logRows(report.runner->logFiles());
    if (const std::string counts = countText(report.diagnostics); !counts.empty()) text += row("messages", counts);
    return text;
}

} // namespace trundle
