#include "model/passive_objects.h"

#include <algorithm>

namespace trundle {

namespace {

/// Blocks of modules that are not loaded count as active.
bool isBody(const Part& part) {
    if (part.isRepeat()) return std::ranges::all_of(part.parts, isBody);
    return part.is(Role::Body) || part.is(Role::Geom);
}

} // namespace

bool isPassive(const RobotSpec& robot) {
    if (!robot.config || !robot.controllers.empty() || robot.scenery) return false;
    return robot.config->joints.empty() && robot.config->springs.empty() && robot.config->devices.empty();
}

bool isPassive(const Part& instance, const Part* config) {
    if (!config || !isPassiveConfig(*config) || !instance.kind) return false;
    if (instance.kind->name == "Static" || !(instance.is(Role::Instance) || instance.is(Role::Layout))) return false;
    return instance.parts.empty();
}

bool isPassiveConfig(const Part& config) {
    if (config.config && !isPassiveConfig(*config.config)) return false; // what it is a variant of
    return config.kind && config.kind->name == "RobotConfig" && std::ranges::all_of(config.parts, isBody);
}

RobotCounts countRobots(const ExperimentSpec& experiment) {
    RobotCounts counts;
    for (const RobotSpec& robot : experiment.robots)
        if (!robot.scenery) ++(isPassive(robot) ? counts.objects : counts.robots);
    return counts;
}

} // namespace trundle
