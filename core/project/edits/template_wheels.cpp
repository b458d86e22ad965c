#include "project/edits/template_wheels.h"

#include <cmath>

#include "project/objects/part_values.h"

namespace trundle {
namespace {

struct Wheel {
    Vec3 centre = Vec3::Zero(), axis = Vec3::UnitY(); // in the config's frame
    double radius = 0;
};

/// From the values of the text, so that a config without instances has wheels too.
class ConfigWheels {
public:
    ConfigWheels(const LoadedProject& loaded, const Part& config) : m_loaded(loaded), m_config(config) {}

    /// The largest round geom of the body that the motor turns.
    [[nodiscard]] std::optional<Wheel> wheelOf(const std::string& motor) const {
        const std::string joint = wordOf(motor, "Joint"), child = wordOf(joint, "Child");
        const Part* body = child.empty() ? nullptr : m_config.find(child);
        const auto axis = value(joint, "Axis");
        if (!body || !axis || axis->numbers.size() != 3) return std::nullopt;
        std::optional<Wheel> wheel;
        for (const Part& geom : body->parts) {
            const auto radius = value(child + "." + geom.name, "Radius");
            if (!geom.is(Role::Geom) || !radius || radius->numbers.empty()) continue;
            if (wheel && radius->numbers[0] <= wheel->radius) continue;
            const Pose X_CG = poseAt(m_loaded, *locationOf(child)) * poseAt(m_loaded, *locationOf(child + "." + geom.name));
            wheel =
                Wheel{X_CG.position, Vec3(axis->numbers[0], axis->numbers[1], axis->numbers[2]).normalized(), radius->numbers[0]};
        }
        return wheel;
    }

private:
    [[nodiscard]] std::optional<ObjectLocation> locationOf(const std::string& inside) const {
        return placeOf(m_loaded, pathOfConfig(m_config) + "." + inside);
    }
    [[nodiscard]] std::optional<PropertyValue> value(const std::string& inside, const std::string& key) const {
        const auto place = inside.empty() ? std::nullopt : locationOf(inside);
        return place && place->part && place->part->kind ? valueAt(m_loaded, *place, key) : std::nullopt;
    }
    [[nodiscard]] std::string wordOf(const std::string& inside, const std::string& key) const {
        const auto word = value(inside, key);
        return word && !word->texts.empty() ? word->texts.front() : std::string();
    }

    const LoadedProject& m_loaded;
    const Part& m_config;
};

} // namespace

std::optional<WheelPair> wheelsOf(const LoadedProject& loaded, const Part& config, const std::string& leftMotor,
                                  const std::string& rightMotor) {
    const ConfigWheels wheels(loaded, config);
    const std::optional<Wheel> left = wheels.wheelOf(leftMotor), right = wheels.wheelOf(rightMotor);
    if (!left || !right) return std::nullopt;
    const double separation = std::abs((left->centre - right->centre).dot(left->axis));
    if (!(left->radius > 0) || !(separation > 0)) return std::nullopt;
    return WheelPair{left->radius, separation};
}

} // namespace trundle
