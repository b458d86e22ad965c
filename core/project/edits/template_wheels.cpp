#include "project/edits/template_wheels.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <vector>

#include "model/dotted_path.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

/// From the values of the text, so that a config without instances has wheels too.
class ConfigWheels {
public:
    explicit ConfigWheels(const TemplateNames& names) : m_names(names) {}

    [[nodiscard]] std::optional<Wheel> wheelOf(const NamedBlock& motor) const {
        const NamedBlock* joint = m_names.named(motor, "Joint");
        const NamedBlock* body = joint ? m_names.named(*joint, "Child") : nullptr;
        const auto axis = joint ? value(joint->name, "Axis") : std::nullopt;
        if (!body || !axis || axis->numbers.size() != 3) return std::nullopt;
        const ObjectLocation at = *m_names.locationOf(body->name);
        const DescribedFrame frame = describedFrame(m_names.loaded(), at);
        const DescribedFrame ofJoint = describedFrame(m_names.loaded(), *m_names.locationOf(joint->name));
        const Vec3 described(axis->numbers[0], axis->numbers[1], axis->numbers[2]);
        std::optional<Wheel> wheel;
        for (const Part& geom : body->part->parts) {
            const std::string name = body->name + "." + geom.name;
            const auto radius = value(name, "Radius");
            if (!geom.is(Role::Geom) || !radius || radius->numbers.empty()) continue;
            if (wheel && radius->numbers[0] <= wheel->radius) continue;
            const Pose inFrame = poseAt(m_names.loaded(), at) * poseAt(m_names.loaded(), *m_names.locationOf(name));
            wheel = Wheel{(frame.pose * frame.mirrored(inFrame)).position,
                          ofJoint.pose.rotation * ofJoint.signs.cwiseProduct(described).normalized(), radius->numbers[0]};
        }
        return wheel;
    }

private:
    [[nodiscard]] std::optional<PropertyValue> value(const std::string& name, const std::string& key) const {
        const auto place = m_names.locationOf(name);
        return place ? valueAt(m_names.loaded(), *place, key) : std::nullopt;
    }

    const TemplateNames& m_names;
};

/// Whether a word has another one in it: "left" in leftMotor and frontLeftMotor, "right" not in brightness.
bool hasWord(std::string_view name, std::string lower) {
    for (std::size_t at = name.find(lower); at != std::string_view::npos; at = name.find(lower, at + 1))
        if (at == 0 || !std::isalpha(static_cast<unsigned char>(name[at - 1]))) return true;
    lower[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(lower[0])));
    return name.find(lower) != std::string_view::npos;
}

/// The two ends of an axis of a robot.
struct Sides {
    int axis = 0;
    std::vector<const char*> positive, negative;

    /// +1 or -1; 0: it says nothing. The outermost word with a side holds, as the mirror image of a left part keeps the names in it.
    [[nodiscard]] int of(std::string_view name) const {
        for (;; name = withoutFirstWord(name)) {
            const auto isIn = [&](const char* word) { return hasWord(firstWord(name), word); };
            if (std::ranges::any_of(positive, isIn)) return 1;
            if (std::ranges::any_of(negative, isIn)) return -1;
            if (firstWord(name) == name) return 0;
        }
    }
};

} // namespace

std::optional<Wheel> wheelOf(const TemplateNames& names, const std::string& motor) {
    const NamedBlock* block = names.find(motor);
    return block ? ConfigWheels(names).wheelOf(*block) : std::nullopt;
}

std::optional<WheelPair> wheelsOf(const TemplateNames& names, const std::string& leftMotor, const std::string& rightMotor) {
    const std::optional<Wheel> left = wheelOf(names, leftMotor), right = wheelOf(names, rightMotor);
    if (!left || !right) return std::nullopt;
    const double separation = std::abs((left->centre - right->centre).dot(left->axis));
    if (!(left->radius > 0) || !(separation > 0)) return std::nullopt;
    return WheelPair{left->radius, separation};
}

int sideMisfit(const TemplateNames* names, const std::string& property, const std::string& block) {
    constexpr double kMiddle = 1e-6; // m
    static const std::array<Sides, 2> kAll{Sides{1, {"left"}, {"right"}}, Sides{0, {"front"}, {"back", "rear"}}};
    int misfit = 0;
    for (const Sides& sides : kAll) {
        const int asked = sides.of(property);
        if (asked == 0) continue;
        int is = sides.of(block);
        const std::optional<Wheel> wheel = is == 0 && names ? wheelOf(*names, block) : std::nullopt;
        if (wheel && std::abs(wheel->centre[sides.axis]) > kMiddle) is = wheel->centre[sides.axis] > 0 ? 1 : -1;
        misfit += is == asked ? 0 : is == 0 ? 1 : 2;
    }
    return misfit;
}

} // namespace trundle
