#include "model/object_numbers.h"

namespace trundle {

std::vector<std::string> objectNames(const ExperimentSpec& experiment) {
    std::vector<std::string> names{""};
    const auto add = [&](const std::string& owner, const std::vector<GeomSpec>& geoms) {
        for (const GeomSpec& geom : geoms) names.push_back(owner + "/" + geom.name);
    };
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) add(robot.name + "/" + body.name, body.geoms);
    }
    for (const StaticSpec& fixed : experiment.statics)
        if (fixed.geoms) add(fixed.name, *fixed.geoms);
    return names;
}

FirstObjects firstObjects(const ExperimentSpec& experiment) {
    FirstObjects first;
    std::uint32_t next = 1;
    for (const RobotSpec& robot : experiment.robots) {
        first.robots.push_back(next);
        if (!robot.config) continue;
        for (const BodySpec& body : robot.config->bodies) next += static_cast<std::uint32_t>(body.geoms.size());
    }
    for (const StaticSpec& fixed : experiment.statics) {
        first.statics.push_back(next);
        if (fixed.geoms) next += static_cast<std::uint32_t>(fixed.geoms->size());
    }
    return first;
}

} // namespace trundle
