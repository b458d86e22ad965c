#include "editor/sensors/shown_devices.h"

#include <algorithm>

#include "model/robot_path.h"

namespace trundle {
namespace {

bool refersTo(const ComponentSpec& device, std::string_view part) {
    return std::ranges::any_of(device.values, [part](const auto& item) {
        return std::ranges::any_of(item.second.value.texts, [part](const std::string& text) {
            return text == part || (text.starts_with(part) && text[part.size()] == '.') ||
                   (part.starts_with(text) && !text.empty() && part[text.size()] == '.');
        });
    });
}

/// Measures what is around the robot or what it feels; does not take commands or report on its drive, its power or its radio.
bool isSensor(const ComponentSpec& device, const Registry& kinds) {
    for (const char* other : {"Encoder", "Battery", "Charger", "Transceiver"})
        if (device.kind == other) return false;
    const Kind* kind = kinds.find(device.kind);
    return kind && std::ranges::none_of(kind->signals,
                                        [](const SignalDescription& signal) { return signal.direction == TRUNDLE_COMMAND; });
}

std::vector<std::string> devicesOf(const RobotSpec& robot, const Registry& kinds, std::string_view part) {
    std::vector<std::string> all, referring, others, otherReferring;
    for (const ControllerSpec& controller : robot.controllers)
        if (controller.name == part || (part.empty() && !controller.published.empty()))
            all.push_back(robot.name + "." + controller.name);
    if (!part.empty() && !all.empty()) return all;
    for (const ComponentSpec& device : robot.config->devices) {
        const std::string path = robot.name + "." + device.name;
        if (device.name == part) return {path};
        const bool sensor = isSensor(device, kinds);
        (sensor ? all : others).push_back(path);
        if (!part.empty() && refersTo(device, part)) (sensor ? referring : otherReferring).push_back(path);
    }
    std::ranges::move(others, std::back_inserter(all));
    std::ranges::move(otherReferring, std::back_inserter(referring));
    return referring.empty() ? all : referring;
}

} // namespace

std::vector<std::string> devicesOf(const ExperimentSpec& experiment, const Registry& kinds, const std::string& path) {
    std::string_view first = firstWord(path), part = withoutFirstWord(path);
    const bool ofConfig = first == "RobotConfig";
    if (ofConfig) {
        first = firstWord(part);
        part = withoutFirstWord(part);
    }
    std::vector<std::string> devices;
    const RobotNames isRobot(experiment.robots);
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        const auto rest = ofConfig ? std::optional(part) : restBehind(path, robot.name, isRobot);
        if (!rest || (ofConfig && robot.config->name != first)) continue;
        std::ranges::copy(devicesOf(robot, kinds, *rest), std::back_inserter(devices));
        if (ofConfig) break;
    }
    return devices;
}

std::vector<std::string> devicesOf(const ExperimentSpec& experiment, const Registry& kinds,
                                   const std::vector<std::string>& paths) {
    std::vector<std::string> all;
    for (const std::string& path : paths)
        for (std::string& device : devicesOf(experiment, kinds, path))
            if (std::ranges::find(all, device) == all.end()) all.push_back(std::move(device));
    return all;
}

} // namespace trundle
