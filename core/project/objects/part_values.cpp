#include "project/objects/part_values.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "lang/characters.h"
#include "model/config_blocks.h"
#include "model/repeat.h"
#include "project/objects/path_scopes.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

Vec3 triple(const std::optional<PropertyValue>& value) {
    if (!value || value->numbers.size() != 3) return Vec3::Zero();
    return {value->numbers[0], value->numbers[1], value->numbers[2]};
}

std::string quoted(const std::string& text) {
    const bool word = !text.empty() && isIdentStart(text[0]) && std::all_of(text.begin(), text.end(), isWordChar) &&
                      text != "true" && text != "false";
    if (word) return text;
    std::string out = "\"";
    for (const char c : text) out += c == '\n' ? "\\n" : c == '"' || c == '\\' ? std::string("\\") + c : std::string(1, c);
    return out + "\"";
}

} // namespace

std::optional<PropertyValue> valueAt(const LoadedProject& loaded, const ObjectLocation& place, const std::string& key) {
    const Property* property = place.part && place.part->kind ? place.part->kind->find(key) : nullptr;
    if (!property) return std::nullopt;
    PathScopes scopes(loaded, place);
    Diagnostics silent;
    const auto read = [&](const SourceAssignment& a, ParamScope& scope) {
        const std::optional<GivenValue> given = scopes.evaluator().evaluate(*a.value, a.file, scope);
        return given ? readValue(*property, *given, silent) : std::nullopt;
    };
    if (const auto set = scopes.overrideOf(key)) return read(*set->assignment, *set->layer->scope);
    if (const SourceAssignment* a = place.part->assignments.find(key)) return read(*a, scopes.scope());
    return property->defaultValue;
}

const SourceAssignment* overrideAt(const LoadedProject& loaded, const ObjectLocation& place, const std::string& key) {
    const PathScopes scopes(loaded, place);
    const std::vector<PathScopes::Override> all = scopes.overridesOf(key, place.part == place.instance);
    const auto own = std::ranges::find_if(all, [&](const auto& set) { return set.layer->instance == place.instance; });
    return place.instance && own != all.end() ? own->assignment : nullptr;
}

std::string shortNumber(double value) {
    for (double power = 1; power < 1e11; power *= 10) {
        const double rounded = std::round(value * power) / power;
        if (!(std::abs(rounded - value) < 1e-10)) continue;
        std::array<char, 32> digits; // "0.0001", not "1e-04"
        const bool isSmall = rounded != 0 && std::abs(rounded) < 1;
        return isSmall ? std::string(
                             digits.data(),
                             std::to_chars(digits.data(), digits.data() + digits.size(), rounded, std::chars_format::fixed).ptr)
                       : numberText(rounded == 0 ? 0.0 : rounded);
    }
    return numberText(value);
}

std::string valueText(const Property& property, const PropertyValue& value) {
    std::string text;
    for (const double number : value.numbers) {
        text += text.empty() ? "" : ",";
        if (property.type == PropertyType::Boolean) text += number != 0 ? "true" : "false";
        else {
            const double written = number / property.scale;
            const double tidy = std::round(written * 1e12) / 1e12; // 90 deg converted to rad and back is 90
            text += numberText(std::abs(tidy - written) <= 1e-14 * std::abs(written) ? tidy : written);
        }
    }
    for (const std::string& word : value.texts) text += (text.empty() ? "" : ",") + quoted(word);
    return text;
}

Pose poseAt(const LoadedProject& loaded, const ObjectLocation& place) {
    return {triple(valueAt(loaded, place, "Pos")), rotationFromHpr(triple(valueAt(loaded, place, "HPR")))};
}

namespace {

/// Where a member of a Ring is in the frame that holds the Ring.
Pose memberPoseAt(const LoadedProject& loaded, const ObjectLocation& place) {
    const auto number = [&](const char* key, double otherwise) {
        const std::optional<PropertyValue> value = valueAt(loaded, place, key);
        return value && !value->numbers.empty() ? value->numbers[0] : otherwise;
    };
    const auto numbers = [&](const char* key, Vec3 otherwise) {
        const std::optional<PropertyValue> value = valueAt(loaded, place, key);
        if (value && value->numbers.size() == 3) otherwise = triple(value);
        return Triple{otherwise.x(), otherwise.y(), otherwise.z()};
    };
    RingFields ring;
    ring.count = number("Count", 1);
    ring.radius = number("Radius", 0);
    ring.axis = numbers("Axis", Vec3::UnitZ());
    ring.pos = numbers("Pos", Vec3::Zero());
    ring.hpr = numbers("HPR", Vec3::Zero());
    return memberPose(ring, place.memberOf(*place.part).value_or(0));
}

} // namespace

Pose DescribedFrame::mirrored(const Pose& described) const {
    const Vec3 turned = signs.prod() * signs.cwiseProduct(described.rotation.vec()); // M R M
    const Quat& q = described.rotation;
    return {signs.cwiseProduct(described.position), Quat(q.w(), turned.x(), turned.y(), turned.z())};
}

const RobotConfigSpec* resolvedConfig(const LoadedProject& loaded, const ObjectLocation& place) {
    const bool isReached = place.instance && !place.instance->isPartUse() && !isVariant(*place.instance);
    for (const RobotSpec& robot : loaded.experiment->robots) {
        if (!robot.config || place.above.empty()) continue;
        const bool isMeant = isReached ? robot.range == place.instance->range : robot.config->name == place.above.front()->name;
        if (isMeant) return robot.config.get();
    }
    return nullptr;
}

std::string resolvedPrefix(const ObjectLocation& place) {
    std::string prefix;
    for (const Part* part : place.above) {
        if (part->isPartUse()) prefix += part->name + ".";
        if (part->isRepeat()) prefix += part->name + "_" + std::to_string(place.memberOf(*part).value_or(0)) + ".";
    }
    return prefix;
}

namespace {

constexpr std::size_t kMostIns = 100; ///< that are followed for one frame: they may be a circle

DescribedFrame frameOf(const LoadedProject& loaded, const ObjectLocation& place, std::size_t& ins);

/// The pose of a body beside or around a block by the texts alone, of a config that no robot has. `ins`: followed so far.
std::optional<Pose> writtenPose(const LoadedProject& loaded, ObjectLocation place, const std::string& body, std::size_t& ins) {
    for (place.part = nullptr; !place.above.empty(); place.above.pop_back())
        if ((place.part = place.above.back()->find(body))) break;
    if (!place.part || !place.part->is(Role::Body) || ++ins > kMostIns) return std::nullopt;
    const DescribedFrame frame = frameOf(loaded, place, ins);
    return frame.pose * frame.mirrored(poseAt(loaded, place));
}

/// The pose in the config of the body that a block's `In` names; nothing if it has none.
std::optional<Pose> poseOfIn(const LoadedProject& loaded, const ObjectLocation& place, std::size_t& ins) {
    const std::optional<PropertyValue> in = valueAt(loaded, place, "In");
    if (!in || in->texts.empty()) return std::nullopt;
    const RobotConfigSpec* config = resolvedConfig(loaded, place);
    if (!config) return writtenPose(loaded, place, in->texts[0], ins);
    for (std::string prefix = resolvedPrefix(place);;) { // in a member of a Repeat also a name around it
        const auto it = std::ranges::find(config->bodies, prefix + in->texts[0], &BodySpec::name);
        if (it != config->bodies.end()) return it->pose;
        if (prefix.empty()) return std::nullopt;
        prefix.pop_back();
        prefix.resize(prefix.rfind('.') + 1); // npos + 1 is 0
    }
}

DescribedFrame frameOf(const LoadedProject& loaded, const ObjectLocation& place, std::size_t& ins) {
    DescribedFrame frame;
    for (std::size_t i = 0; i < place.above.size(); ++i) {
        if (place.above[i]->is(Role::Body)) frame.pose = {}; // geoms are described in their body
        if (!place.above[i]->isPartUse() && !place.above[i]->isRepeat()) continue;
        ObjectLocation use;
        use.part = place.above[i];
        use.instance = place.instance;
        use.members = place.members;
        use.above.assign(place.above.begin(), place.above.begin() + static_cast<std::ptrdiff_t>(i));
        if (const std::optional<Pose> in = poseOfIn(loaded, use, ins)) frame.pose = *in;
        const bool isRing = use.part->kind->name == "Ring";
        frame.pose = frame.pose * frame.mirrored(isRing ? memberPoseAt(loaded, use) : poseAt(loaded, use));
        const std::optional<PropertyValue> mirror = valueAt(loaded, use, "Mirror");
        const std::string axis = mirror && !mirror->texts.empty() ? mirror->texts[0] : std::string();
        if (axis == "x" || axis == "y" || axis == "z") frame.signs[axis[0] - 'x'] *= -1;
    }
    if (const std::optional<Pose> in = place.part ? poseOfIn(loaded, place, ins) : std::nullopt) frame.pose = *in;
    return frame;
}

} // namespace

DescribedFrame describedFrame(const LoadedProject& loaded, const ObjectLocation& place) {
    std::size_t ins = 0;
    return frameOf(loaded, place, ins);
}

Pose poseInConfig(const LoadedProject& loaded, const ObjectLocation& place) {
    const DescribedFrame frame = describedFrame(loaded, place);
    return frame.pose * frame.mirrored(poseAt(loaded, place));
}

std::string positionText(const Vec3& p) { return shortNumber(p.x()) + "," + shortNumber(p.y()) + "," + shortNumber(p.z()); }

std::string headingText(const Quat& rotation) { return positionText(hprFromRotation(rotation) * (180 / std::numbers::pi)); }

} // namespace trundle
