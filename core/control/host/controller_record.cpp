#include "control/host/controller_record.h"

#include <algorithm>

#include "model/signal_count.h"

namespace trundle {
namespace {

constexpr std::string_view kPeriod = "UpdatePeriod";

void writeController(WireWriter& out, const ControllerSpec& controller) {
    out.bytes(controller.kind).number<std::uint64_t>(controller.values.size());
    for (const auto& [key, value] : controller.values) out.bytes(key).value(value.value);
    out.number<std::uint64_t>(controller.published.size());
    for (const SignalDescription& signal : controller.published)
        out.bytes(signal.name).number(signal.direction).number(signalCount(signal, controller));
}

void readController(WireReader& in, ControllerSpec& controller) {
    controller.kind = in.text();
    for (std::uint64_t left = in.count(); left > 0; --left) {
        std::string key = in.text();
        controller.values[std::move(key)].value = in.value();
    }
    for (std::uint64_t left = in.count(); left > 0; --left) {
        controller.published.emplace_back();
        controller.published.back().name = in.text();
        controller.published.back().direction = in.number<std::uint32_t>();
        controller.published.back().count = in.number<std::uint32_t>();
    }
}

} // namespace

void write(WireWriter& out, const RobotSpec& robot, std::size_t controller, const SettingsSpec& settings,
           const SignalLayout::Range& entries, std::uint64_t offset) {
    out.number(offset).number(settings.seed).number(settings.tick).bytes(robot.name);
    out.number<std::uint64_t>(robot.controllers.size());
    for (const ControllerSpec& each : robot.controllers) out.bytes(each.name);
    out.number<std::uint64_t>(controller);
    writeController(out, robot.controllers[controller]);
    out.number<std::uint64_t>(robot.config->devices.size());
    for (const ComponentSpec& device : robot.config->devices)
        out.bytes(device.kind).bytes(device.name).number(device.number(kPeriod));
    out.number<std::uint64_t>(entries.size());
    for (const SignalEntry& entry : entries)
        out.bytes(entry.path)
            .number(static_cast<std::uint32_t>(entry.type))
            .number(static_cast<std::uint32_t>(entry.direction))
            .number(entry.count);
}

ControllerRecord readControllerRecord(WireReader& in) {
    ControllerRecord record;
    record.offset = in.number<std::uint64_t>();
    record.settings.seed = in.number<std::uint64_t>();
    record.settings.tick = in.number<double>();
    record.robot.name = in.text();
    for (std::uint64_t left = in.count(); left > 0; --left) {
        record.robot.controllers.emplace_back();
        record.robot.controllers.back().name = in.text();
    }
    record.controller = in.number<std::uint64_t>();
    readController(in, record.robot.controllers.at(record.controller));
    auto config = std::make_shared<RobotConfigSpec>();
    for (std::uint64_t left = in.count(); left > 0; --left) {
        ComponentSpec device;
        device.kind = in.text();
        device.name = in.text();
        device.values[std::string(kPeriod)].value.numbers = {in.number<double>()};
        config->devices.push_back(std::move(device));
    }
    record.robot.config = std::move(config);
    record.layout.beginRobot(record.robot.name);
    for (std::uint64_t left = in.count(); left > 0; --left) {
        std::string name = in.text().substr(record.robot.name.size() + 1);
        const auto type = static_cast<SignalType>(in.number<std::uint32_t>());
        const auto direction = static_cast<SignalDirection>(in.number<std::uint32_t>());
        record.layout.add(std::move(name), {}, type, direction, in.number<std::uint32_t>());
    }
    return record;
}

} // namespace trundle
