#include "scene/queries/range_model.h"

#include <numbers>

namespace trundle {
namespace {

constexpr double kFullCircle = 2 * std::numbers::pi;
constexpr std::size_t kMaxBeams = 20000; // a sensor with more is not drawn

Vec3 vectorValue(const ComponentSpec& spec, std::string_view key) {
    const ResolvedValue* value = spec.find(key);
    return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : Vec3(Vec3::Zero());
}

/// As core/devices/lidar.h says.
void addBeams(const ComponentSpec& spec, RangeModel& model) {
    model.beams = static_cast<std::uint32_t>(spec.number("Beams", 1));
    model.layers = static_cast<std::uint32_t>(std::max(1.0, spec.number("Layers", 1)));
    const double field = spec.number("FieldOfView", kFullCircle), vertical = spec.number("VerticalFieldOfView", 0);
    model.closed = field > kFullCircle * (1 - 1e-9);
    if (std::size_t(model.beams) * model.layers > kMaxBeams) return;
    for (std::uint32_t layer = 0; layer < model.layers; ++layer) {
        const double up = model.layers > 1 ? vertical * (layer / (model.layers - 1.0) - 0.5) : 0;
        for (std::uint32_t i = 0; i < model.beams; ++i) {
            const double steps = model.closed ? model.beams : model.beams - 1.0;
            const double bearing = model.beams > 1 ? field * (i / steps - 0.5) : 0;
            model.directions.push_back({std::cos(up) * std::cos(bearing), std::cos(up) * std::sin(bearing), std::sin(up)});
        }
    }
}

/// Reads the properties by the names that the kinds Lidar, RangeSensor and GroundSensor declare; a module's sensor may use them too.
RangeModel modelFrom(const ComponentSpec& spec) {
    RangeModel model;
    model.mounting = {vectorValue(spec, "Pos"), rotationFromHpr(vectorValue(spec, "HPR"))};
    model.maxRange = spec.number("MaxRange", 1);
    model.ground = !spec.find("MaxRange");
    if (model.ground) {
        model.maxRange = spec.number("MaxHeight", 1);
        model.directions = {-Vec3::UnitZ()};
    } else if (spec.find("Beams")) {
        addBeams(spec, model);
    } else {
        model.coneAngle = spec.number("ConeAngle", spec.text("Type") == "ultrasonic" ? kFullCircle / 12 : 0);
        model.directions = {Vec3::UnitX()};
    }
    return model;
}

} // namespace

std::optional<RangeModel> rangeModelOf(const ComponentSpec& device) {
    if ((!device.find("MaxRange") && !device.find("MaxHeight")) || !device.find("Body")) return std::nullopt;
    RangeModel model = modelFrom(device);
    if (model.directions.empty()) return std::nullopt;
    return model;
}

std::vector<RangeModel> rangeModelsOf(const ExperimentSpec& experiment) {
    std::vector<RangeModel> models;
    std::size_t firstBody = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            std::optional<RangeModel> known = rangeModelOf(device);
            if (!known) continue;
            RangeModel& model = *known;
            model.path = robot.name + "/" + device.name;
            model.robot = robot.name;
            const std::string body = device.text("Body");
            for (std::size_t b = 0; b < robot.config->bodies.size(); ++b)
                if (robot.config->bodies[b].name == body) model.body = firstBody + b;
            models.push_back(std::move(model));
        }
        firstBody += robot.config->bodies.size();
    }
    return models;
}

} // namespace trundle
