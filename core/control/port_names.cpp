#include "control/port_names.h"

#include <algorithm>

#include <trundle/device_signals.h>

#include "base/spelling.h"
#include "model/port_kinds.h"

namespace trundle {
namespace {

constexpr std::string_view kTruthKind = GroundTruthSignals::kKind, kTruthName = "groundTruth";

const ComponentSpec* findDevice(const RobotSpec& robot, const std::string& name) {
    for (const ComponentSpec& device : robot.config->devices)
        if (device.name == name) return &device;
    return nullptr;
}

std::string meant(const std::string& word, const std::vector<std::string>& candidates) {
    const auto near = nearestWords(word, candidates, 1);
    return near.empty() ? "" : "; did you mean '" + near.front() + "'?";
}

std::string listed(const std::vector<std::string>& words) {
    constexpr std::size_t most = 30;
    std::string text;
    for (std::size_t i = 0; i < words.size() && i < most; ++i) text += (i ? ", " : "") + words[i];
    return words.empty() ? "none" : words.size() > most ? text + " ..." : text;
}

Error unknown(const RobotSpec& robot, const std::string& what) { return {Code::UnknownPort, robot.name + " " + what}; }

} // namespace

/// Names of the robot's devices; only those of the requested kind if there are any.
std::string PortNames::devices(const std::string& kind) const {
    std::vector<std::string> fitting, all;
    for (const ComponentSpec& device : m_robot.config->devices) {
        all.push_back(device.name + " (" + device.kind + ")");
        if (device.kind == kind) fitting.push_back(device.name);
    }
    if (!fitting.empty()) return "its " + kind + " ports: " + listed(fitting);
    return "its ports: " + listed(all);
}

std::string PortNames::signalsBelow(const std::string& prefix, bool truth) const {
    std::vector<std::string> names;
    for (const SignalEntry& entry : m_layout.entriesOf(m_robot.name))
        if (entry.path.starts_with(prefix) && (entry.direction == SignalDirection::Truth) == truth)
            names.push_back(entry.path.substr(prefix.size()));
    return listed(names);
}

Result<SignalEntry> PortNames::truth(const std::string& name, const std::string& signal) const {
    if (name != kTruthName) return unknown(m_robot, "has no port '" + name + "'; ground truth is the port groundTruth");
    const auto entry = m_layout.find(m_robot.name + "/" + signal);
    if (entry && entry->direction == SignalDirection::Truth) return *entry;
    return unknown(m_robot, "has no ground truth '" + signal + "'; there is: " + signalsBelow(m_robot.name + "/", true));
}

Result<SignalEntry> PortNames::bind(const std::string& kind, const std::string& device, const std::string& signal) const {
    if (kind == kTruthKind) return truth(device, signal);
    const ComponentSpec* spec = findDevice(m_robot, device);
    if (!spec) {
        std::vector<std::string> names;
        for (const ComponentSpec& d : m_robot.config->devices)
            if (kind.empty() || d.kind == kind) names.push_back(d.name);
        const std::string wanted = kind.empty() ? "port" : kind + " port";
        return unknown(m_robot, "has no " + wanted + " '" + device + "'" + meant(device, names) + " (" + devices(kind) + ")");
    }
    if (!portFits(kind, spec->kind))
        return unknown(m_robot,
                       "has no " + kind + " port '" + device + "': that is of kind " + spec->kind + " (" + devices(kind) + ")");
    const std::string prefix = m_robot.name + "/" + device + "/";
    const auto entry = m_layout.find(prefix + signal);
    if (!entry)
        return unknown(m_robot, "has no signal '" + device + "/" + signal + "'; the signals of " + device + ": " +
                                    signalsBelow(prefix, false));
    if (entry->direction == SignalDirection::Truth)
        return unknown(m_robot, "gives '" + device + "/" + signal +
                                    "' through the port groundTruth alone: a real robot cannot measure it");
    return *entry;
}

Result<SignalEntry> PortNames::published(const std::string& signal) const {
    if (!m_controller) return unknown(m_robot, "has no controller in its text that could publish '" + signal + "'");
    const std::string prefix = m_robot.name + "/" + m_controller->name + "/";
    const auto entry = m_layout.find(prefix + signal);
    if (entry) return *entry;
    std::vector<std::string> names;
    for (const SignalDescription& s : m_controller->published) names.push_back(s.name);
    return unknown(m_robot, "cannot publish '" + signal + "'" + meant(signal, names) + " (describe() of " +
                                m_controller->kind + " names as outputs: " + signalsBelow(prefix, false) + ")");
}

std::optional<SignalEntry> PortNames::look(const std::string& device, const std::string& signal) const {
    if (!device.empty() && !findDevice(m_robot, device)) return std::nullopt;
    const std::string path = m_robot.name + "/" + (device.empty() ? "" : device + "/") + signal;
    if (!signal.empty()) return m_layout.find(path);
    for (const SignalEntry& entry : m_layout.entriesOf(m_robot.name))
        if (entry.path.starts_with(path)) return entry;
    return std::nullopt;
}

} // namespace trundle
