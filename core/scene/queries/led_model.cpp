#include "scene/queries/led_model.h"

namespace trundle {
namespace {

Vec3 ledTriple(const ComponentSpec& spec, std::string_view key, const Vec3& otherwise) {
    const ResolvedValue* value = spec.find(key);
    return value && value->value.numbers.size() == 3 ? Vec3(value->value.numbers.data()) : otherwise;
}

/// Reads the properties by the names that the kind Led declares.
LedModel ledFrom(const ComponentSpec& spec) {
    LedModel led;
    led.mounting = {ledTriple(spec, "Pos", Vec3::Zero()), rotationFromHpr(ledTriple(spec, "HPR", Vec3::Zero()))};
    led.diameter = spec.number("Diameter", led.diameter);
    const Vec3 colour = ledTriple(spec, "ColorRGB", Vec3::Ones());
    for (int k = 0; k < 3; ++k) led.colour[static_cast<std::size_t>(k)] = static_cast<float>(colour[k]);
    if (spec.number("On", 1) != 0) led.atStart = led.colour;
    return led;
}

} // namespace

std::vector<LedModel> ledsOf(const ExperimentSpec& experiment) {
    std::vector<LedModel> leds;
    std::size_t firstBody = 0;
    for (const RobotSpec& robot : experiment.robots) {
        if (!robot.config) continue;
        for (const ComponentSpec& device : robot.config->devices) {
            if (device.kind != "Led") continue;
            LedModel led = ledFrom(device);
            led.path = robot.name + "/" + device.name;
            const std::string body = device.text("Body");
            for (std::size_t b = 0; b < robot.config->bodies.size(); ++b)
                if (robot.config->bodies[b].name == body) led.body = firstBody + b;
            leds.push_back(std::move(led));
        }
        firstBody += robot.config->bodies.size();
    }
    return leds;
}

} // namespace trundle
