#include "editor/text/symbols/property_text.h"

#include "schema/value_words.h"

namespace trundle {

std::string typeText(const Property& property) {
    const bool many = property.minCount != 1 || property.maxCount != 1;
    switch (property.type) {
    case PropertyType::Boolean: return "true or false";
    case PropertyType::Choice: return listText(property.choices);
    case PropertyType::File: return "a file (" + listText(property.choices) + ")";
    case PropertyType::Text:
        if (property.choices.empty()) return many ? countText(property) : "text";
        [[fallthrough]];
    case PropertyType::Reference: return (many ? "names of " : "name of ") + listText(property.choices);
    case PropertyType::Integer: return many ? countText(property) : "whole number";
    case PropertyType::Number: break;
    }
    if (property.unit.empty()) return countText(property);
    return many ? countText(property) + " in " + property.unit : property.unit;
}

std::string defaultText(const Property& property) {
    if (!property.defaultValue) return {};
    const PropertyValue& value = *property.defaultValue;
    std::string text;
    const auto add = [&](const std::string& word) { text += (text.empty() ? "" : ", ") + word; };
    for (const double number : value.numbers) {
        if (property.type == PropertyType::Boolean) add(number != 0 ? "true" : "false");
        else add(numberText(property.scale != 0 ? number / property.scale : number));
    }
    for (const std::string& word : value.texts) add(word);
    return text;
}

std::string factsText(const Property& property) {
    std::string text = typeText(property);
    if (const std::string limit = limitText(property); !limit.empty()) text += ", " + limit;
    if (const std::string usual = defaultText(property); !usual.empty()) text += ", default " + usual;
    if (property.required) text += ", required";
    return text;
}

} // namespace trundle
