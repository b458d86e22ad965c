#include "schema/kind.h"

#include <algorithm>

namespace trundle {

namespace {

std::vector<std::string> splitChoices(std::string_view text) {
    std::vector<std::string> words(1);
    for (const char c : text) {
        if (c == '|') words.emplace_back();
        else words.back() += c;
    }
    std::erase(words, std::string());
    return words;
}

PropertyType typeFrom(std::uint32_t type) {
    switch (type) {
    case TRUNDLE_INTEGER: return PropertyType::Integer;
    case TRUNDLE_BOOLEAN: return PropertyType::Boolean;
    case TRUNDLE_CHOICE: return PropertyType::Choice;
    case TRUNDLE_TEXT: return PropertyType::Text;
    case TRUNDLE_FILE: return PropertyType::File;
    case TRUNDLE_REFERENCE: return PropertyType::Reference;
    default: return PropertyType::Number;
    }
}

} // namespace

const Property* Kind::find(std::string_view property) const {
    const auto it = std::find_if(properties.begin(), properties.end(), [&](const Property& p) { return p.name == property; });
    return it == properties.end() ? nullptr : &*it;
}

Property propertyFrom(const FieldInfo& field) {
    Property p;
    p.name = field.name;
    p.unit = field.unit;
    p.help = field.help;
    p.type = typeFrom(field.type);
    p.choices = splitChoices(field.choices);
    p.scale = field.scale;
    p.minimum = field.minimum;
    p.maximum = field.maximum;
    p.minExclusive = field.flags & TRUNDLE_MIN_EXCLUSIVE;
    p.maxExclusive = field.flags & TRUNDLE_MAX_EXCLUSIVE;
    p.required = field.flags & TRUNDLE_REQUIRED;
    p.live = field.flags & TRUNDLE_LIVE;
    p.minCount = field.minCount;
    p.maxCount = field.maxCount;
    if (!p.required && !(field.flags & TRUNDLE_OPTIONAL))
        p.defaultValue = PropertyValue{p.type, field.defaultNumbers, field.defaultTexts};
    return p;
}

Alternatives alternativesFrom(const AlternativesInfo& alternatives) {
    return {splitChoices(alternatives.names), alternatives.likely};
}

SignalDescription signalFrom(const SignalInfo& signal) {
    return {signal.name, signal.unit, signal.help, signal.type, signal.count, signal.direction, signal.countFields};
}

} // namespace trundle
