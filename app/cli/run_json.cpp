#include <cmath>

#include <nlohmann/json.hpp>

#include "base/platform/memory.h"
#include "cli/diagnostic_json.h"
#include "cli/run_report.h"
#include "model/passive_objects.h"
#include "run/logs/signal_columns.h"
#include "run/schedule.h"

namespace trundle {
namespace {

using Json = nlohmann::ordered_json;

Json numberJson(double value, SignalType type) {
    if (type == SignalType::Boolean) return value != 0;
    if (type == SignalType::Integer && std::fabs(value) < 9e15) return static_cast<std::int64_t>(value);
    return value == 0 ? 0.0 : value;
}

Json signalJson(const SignalEntry& entry, std::span<const double> slots) {
    std::vector<double> numbers;
    SignalColumns(entry).read(slots, numbers);
    if (entry.count == 1) return numberJson(numbers[0], entry.type);
    Json list = Json::array();
    for (const double number : numbers) list.push_back(numberJson(number, entry.type));
    return list;
}

Json triple(const Vec3& v) { return Json::array({v.x() + 0.0, v.y() + 0.0, v.z() + 0.0}); }

/// Poses of the robots, without their signals.
Json posesJson(const World& world) {
    Json robots = Json::object();
    const std::vector<RobotSpec>& specs = world.experiment().robots;
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const Pose pose = world.reportedPose(i);
        robots[specs[i].name] = {{"pos", triple(pose.position)},
                                 {"hpr", triple(hprFromRotation(pose.rotation).unaryExpr(&readableDegrees))},
                                 {"signals", Json::object()}};
    }
    return robots;
}

Json robotsJson(const World& world) {
    Json robots = posesJson(world);
    for (const SignalEntry& entry : world.layout().entries()) {
        const std::size_t slash = entry.path.find('/');
        if (slash == std::string::npos) continue;
        const auto robot = robots.find(entry.path.substr(0, slash));
        if (robot != robots.end()) (*robot)["signals"][entry.path.substr(slash + 1)] = signalJson(entry, world.block().slots());
    }
    return robots;
}

/// Names of the passive robots, such as balls and crates.
Json objectsJson(const World& world) {
    Json names = Json::array();
    for (const RobotSpec& robot : world.experiment().robots)
        if (isPassive(robot)) names.push_back(robot.name);
    return names;
}

/// Robots and objects that ended by a fault of their own while the run continued.
Json endsJson(const World& world) {
    Json ends = Json::array();
    for (const auto& [robot, fault] : world.robotFaults().ends)
        ends.push_back({{"robot", world.experiment().robots[robot].name},
                        {"body", fault.body},
                        {"reason", fault.reason},
                        {"time", nearestTickTime(fault.time, world.experiment().settings.tick)}});
    return ends;
}

/// Controllers that a fault stopped while the run continued.
Json stoppedJson(const Runner& runner, const ExperimentSpec& experiment) {
    Json list = Json::array();
    for (const auto& [robot, controller, time, fault, byCommand] : runner.stoppedControllers())
        list.push_back({{"robot", experiment.robots[robot].name},
                        {"controller", controller},
                        {"reason", fault.reason},
                        {"backtrace", fault.backtrace},
                        {"own", fault.isOwn || byCommand},
                        {"time", time}});
    return list;
}

Json finishJson(const RunFinish* finish) {
    if (!finish) return nullptr;
    return {{"robot", finish->robot}, {"controller", finish->controller}, {"reason", finish->reason}, {"time", finish->time}};
}

} // namespace

std::string posesJsonMembers(const World& world) {
    std::string object = posesJson(world).dump(-1, ' ', false, Json::error_handler_t::replace);
    return object.substr(1, object.size() - 2);
}

std::string runJson(const RunReport& report) {
    World* world = report.runner ? &report.runner->world() : nullptr;
    const double simulated = world ? tickTime(world->ticks(), world->experiment().settings.tick) : 0;
    Json json;
    json["ticks"] = world ? world->ticks() : 0;
    json["simulated_s"] = simulated;
    json["wall_s"] = report.wallS;
    json["real_time_factor"] = report.wallS > 0 ? simulated / report.wallS : 0;
    json["peak_memory_kb"] = peakMemoryKb();
    json["engine"] = world ? Json(nameOf(world->experiment().settings.engine)) : Json(nullptr);
    if (world && !world->experiment().settings.whyGeneral.empty())
        json["engine_reason"] = world->experiment().settings.whyGeneral;
    json["threads"] = world ? Json(threadsFor(world->experiment())) : Json(nullptr);
    json["state_hash"] = world ? Json(hashText(world->stateHash())) : Json(nullptr);
    json["quick_ticks"] = world ? world->solves().quickTicks : 0;
    json["rescued_ticks"] = world ? world->solves().rescuedTicks : 0;
    json["interrupted"] = report.interrupted;
    json["finished"] = finishJson(report.runner ? report.runner->finished() : nullptr);
    json["robots"] = world ? robotsJson(*world) : Json::object();
    json["objects"] = world ? objectsJson(*world) : Json::array();
    json["ended"] = world ? endsJson(*world) : Json::array();
    json["stopped"] = world ? stoppedJson(*report.runner, world->experiment()) : Json::array();
    json["diagnostics"] = diagnosticsJson(report.diagnostics, report.sources);
    if (!report.unreadable.empty()) json["diagnostics"][0]["file"] = report.unreadable;
    return jsonText(json);
}

} // namespace trundle
