#include "editor/sensors/sensor_device.h"

#include <algorithm>

#include "editor/sensors/true_values.h"
#include "model/robot_path.h"
#include "model/object_numbers.h"
#include "run/logs/signal_columns.h"

namespace trundle {
namespace {

/// Limits of a signal by the properties of its device; they hold for a module's devices with the same names too.
struct LimitRule {
    const char *signal, *low, *high; ///< names of properties; empty: 0, 1
    bool symmetric = false;          ///< from -high to high
};
constexpr LimitRule kLimitRules[] = {{"range", "MinRange", "MaxRange"},
                                     {"ranges", "MinRange", "MaxRange"},
                                     {"illuminance", "", "MaxIlluminance"},
                                     {"reflectance", "", ""},
                                     {"level", "", ""},
                                     {"charge", "", "Capacity"},
                                     {"voltage", "", "MaxVoltage", true},
                                     {"terminalVoltage", "", "MaxVoltage", true},
                                     {"torque", "", "MaxTorque", true},
                                     {"force", "", "MaxForce", true}};

std::optional<std::pair<double, double>> limitsOf(const ComponentSpec& device, const std::string& signal) {
    for (const LimitRule& rule : kLimitRules) {
        const bool fits = signal == rule.signal && (*rule.high == 0 || device.find(rule.high));
        if (!fits) continue;
        const double high = *rule.high ? device.number(rule.high) : 1, low = *rule.low ? device.number(rule.low) : 0;
        return std::pair(rule.symmetric ? -high : low, high);
    }
    return std::nullopt;
}

Reading::Read slotsFrom(std::size_t from, std::size_t count) {
    return [from, count](const LiveSnapshot& snapshot, double* numbers) {
        std::copy_n(snapshot.block->slots().data() + from, count, numbers);
    };
}

class ReadingList {
public:
    std::vector<Reading> readings;

    void addSignal(const SignalEntry& entry, Reading reading) {
        reading.signal = entry.path;
        reading.type = entry.type;
        reading.unit = entry.unit;
        reading.commanded = entry.direction == SignalDirection::Command;
        switch (shapeOf(entry)) {
        case SignalShape::Pose: add(reading, " position", "m", entry.offset, 3); return addRotation(reading, entry.offset + 3);
        case SignalShape::Velocity:
            add(reading, "", "m/s", entry.offset, 3);
            return add(reading, ", angular", "rad/s", entry.offset + 3, 3);
        case SignalShape::PlanePose:
            add(reading, " x, y", "m", entry.offset, 2);
            add(reading, " heading", "rad", entry.offset + 2, 1);
            readings.back().isAngle = true;
            return;
        case SignalShape::Plain: break;
        }
        if (entry.count > kMaxShownNumbers) return addExtremes(std::move(reading), entry.offset, entry.count);
        const std::string unit = reading.unit;
        add(std::move(reading), "", unit.c_str(), entry.offset, entry.count);
        readings.back().isAngle = entry.unit == "rad" && entry.path.ends_with("/heading");
    }

private:
    void add(Reading reading, const char* suffix, const char* unit, std::size_t from, std::size_t count) {
        reading.name += suffix;
        reading.unit = unit;
        reading.count = count;
        reading.read = slotsFrom(from, count);
        readings.push_back(std::move(reading));
    }
    void addRotation(Reading reading, std::size_t from) {
        reading.name += " HPR";
        reading.unit = "rad";
        reading.count = 3;
        reading.read = [from](const LiveSnapshot& snapshot, double* numbers) {
            const double* q = snapshot.block->slots().data() + from;
            const Vec3 hpr = hprFromRotation(Quat(q[0], q[1], q[2], q[3]).normalized());
            std::copy_n(hpr.data(), 3, numbers);
        };
        readings.push_back(std::move(reading));
    }
    void addExtremes(Reading reading, std::size_t from, std::size_t count) {
        reading.name += " least, greatest";
        reading.help += (reading.help.empty() ? "Of " : " Of ") + std::to_string(count) + " numbers.";
        reading.count = 2;
        reading.read = [from, count](const LiveSnapshot& snapshot, double* numbers) {
            const double* first = snapshot.block->slots().data() + from;
            const auto [least, greatest] = std::minmax_element(first, first + count);
            numbers[0] = *least;
            numbers[1] = *greatest;
        };
        readings.push_back(std::move(reading));
    }
};

SensorPicture pictureOf(const SensorDevice& device, const ComponentSpec& spec) {
    const auto has = [&](std::string_view signal) {
        return std::ranges::any_of(device.readings, [&](const Reading& reading) { return reading.name == signal; });
    };
    if (device.fan) return SensorPicture::Polar;
    if (spec.kind == "Camera") return SensorPicture::Camera;
    if (has("heading")) return SensorPicture::Dial;
    return has("level") && spec.find("Capacity") ? SensorPicture::Battery : SensorPicture::None;
}

/// `prefix`: of its signals.
SensorDevice deviceOf(const RunResults& run, const RobotSpec& robot, const ComponentSpec& spec, const std::string& prefix) {
    SensorDevice device;
    device.kind = run.built->registry->find(spec.kind);
    ReadingList list;
    std::shared_ptr<const std::vector<std::string>> objects;
    for (const SignalEntry& entry : run.layout->entries()) {
        if (!entry.path.starts_with(prefix)) continue;
        Reading reading;
        reading.name = entry.path.substr(prefix.size());
        if (device.kind)
            for (const SignalDescription& described : device.kind->signals)
                if (described.name == reading.name) reading.help = described.help;
        reading.limits = limitsOf(spec, reading.name);
        if (entry.path.ends_with("/object") && entry.direction == SignalDirection::Truth && run.experiment) {
            if (!objects) objects = std::make_shared<const std::vector<std::string>>(objectNames(*run.experiment));
            reading.names = objects;
        }
        list.addSignal(entry, std::move(reading));
    }
    device.readings = std::move(list.readings);
    addTrueValues(run, robot, spec, device.readings);
    if (const auto time = run.layout->find(prefix + "time"))
        device.hasReading = [at = time->offset](const LiveSnapshot& snapshot) { return snapshot.block->slots()[at] >= 0; };
    return device;
}

} // namespace

std::optional<SensorDevice> sensorDeviceAt(const RunResults& run, const std::string& path) {
    const std::string owner = run.experiment ? robotNameIn(*run.experiment, path) : std::string();
    const RobotSpec* robot = run.robot(owner);
    if (!robot || !robot->config || !run.layout) return std::nullopt;
    const std::string_view name = std::string_view(path).substr(std::min(path.size(), owner.size() + 1));
    const ComponentSpec* spec = nullptr;
    for (const ControllerSpec& controller : robot->controllers)
        if (controller.name == name) spec = &controller;
    for (const ComponentSpec& device : robot->config->devices)
        if (device.name == name) spec = &device;
    if (!spec) return std::nullopt;
    const std::string component = robot->name + "/" + spec->name;
    SensorDevice device = deviceOf(run, *robot, *spec, component + "/");
    device.path = path;
    device.component = component;
    if (spec->find("Beams"))
        if (const auto fan = rangeModelOf(*spec)) device.fan = std::make_shared<const RangeModel>(*fan);
    device.picture = pictureOf(device, *spec);
    return device;
}

} // namespace trundle
