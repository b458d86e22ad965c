#include "project/objects/part_values.h"

#include <cmath>
#include <deque>
#include <numbers>

#include "lang/characters.h"
#include "model/params.h"
#include "schema/value_words.h"

namespace trundle {

namespace {

/// The Params in scope at a part, with the values that an instance sets.
class Scopes {
public:
    Scopes(const LoadedProject& loaded, const ObjectLocation& place) : m_evaluator(loaded.outline->texts(), m_silent) {
        m_scopes.emplace_back(nullptr).declare(loaded.outline->params);
        const bool inConfig =
            place.instance && place.part != place.instance && (place.above.empty() || place.above.front() != place.instance);
        if (inConfig) m_instance = &m_scopes.emplace_back(&m_scopes.front());
        if (m_instance) m_instance->declare(place.instance->params);
        ParamScope* outer = &m_scopes.front();
        std::vector<const Part*> chain = place.above;
        if (place.part) chain.push_back(place.part);
        for (const Part* part : chain) {
            ParamScope& scope = m_scopes.emplace_back(outer);
            scope.declare(part->params);
            if (m_instance && part->is(Role::Config)) preset(scope, *part, *place.instance);
            outer = &scope;
        }
        m_inner = outer;
    }

    std::optional<PropertyValue> read(const SourceAssignment& a, const Property& property, bool override) {
        ParamScope& scope = override && m_instance ? *m_instance : *m_inner;
        const std::optional<GivenValue> given = m_evaluator.evaluate(*a.value, a.file, scope);
        return given ? readValue(property, *given, m_silent) : std::nullopt;
    }

private:
    void preset(ParamScope& scope, const Part& config, const Part& instance) {
        for (const SourceParam& p : config.params) {
            const SourceAssignment* a = instance.assignments.find(p.name->text);
            if (!a || (instance.kind && instance.kind->find(p.name->text))) continue;
            if (const auto value = m_evaluator.evaluate(*a->value, a->file, *m_instance)) scope.preset(p.name->text, *value);
        }
    }

    Diagnostics m_silent;
    Evaluator m_evaluator;
    std::deque<ParamScope> m_scopes; // a deque: the scopes point to each other
    ParamScope* m_instance = nullptr;
    ParamScope* m_inner = nullptr;
};

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
    Scopes scopes(loaded, place);
    if (place.instance && place.part != place.instance) {
        if (const SourceAssignment* a = place.instance->assignments.find(place.within + "." + key))
            return scopes.read(*a, *property, true);
    }
    if (const SourceAssignment* a = place.part->assignments.find(key)) return scopes.read(*a, *property, false);
    return property->defaultValue;
}

std::string shortNumber(double value) {
    for (double power = 1; power < 1e11; power *= 10) {
        const double rounded = std::round(value * power) / power;
        if (std::abs(rounded - value) < 1e-10) return numberText(rounded == 0 ? 0.0 : rounded);
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

std::string positionText(const Vec3& p) { return shortNumber(p.x()) + "," + shortNumber(p.y()) + "," + shortNumber(p.z()); }

std::string headingText(const Quat& rotation) { return positionText(hprFromRotation(rotation) * (180 / std::numbers::pi)); }

} // namespace trundle
