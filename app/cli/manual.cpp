#include "cli/manual.h"

#include <cmath>
#include <filesystem>

#include <nlohmann/json.hpp>

#include "cli/numbers.h"
#include "schema/allowed_parents.h"

namespace trundle {
namespace {

using Json = nlohmann::ordered_json;

struct RoleText {
    Role role;
    const char* name;
    const char* title;
};
constexpr RoleText kRoles[] = {
    {Role::Settings, "settings", "Settings of an experiment"},
    {Role::Instance, "instance", "Things in the world"},
    {Role::Layout, "layout", "Many robots at once"},
    {Role::Repeat, "repeat", "Blocks of a config several times"},
    {Role::Config, "config", "Descriptions of robots and arenas"},
    {Role::Material, "material", "How things look"},
    {Role::Surface, "surface", "How things slide and bounce"},
    {Role::Pattern, "pattern", "Antennas"},
    {Role::Medium, "medium", "The air between radios"},
    {Role::Body, "body", "Bodies"},
    {Role::Geom, "geom", "Shapes of bodies and arenas"},
    {Role::Joint, "joint", "Joints between bodies"},
    {Role::Device, "device", "Sensors and actuators"},
    {Role::Controller, "controller", "Controllers"},
    {Role::Log, "log", "Logs"},
    {Role::Look, "look", "Lights and views"},
    {Role::Region, "region", "Regions"},
};

const char* roleWord(Role role) {
    for (const RoleText& text : kRoles)
        if (text.role == role) return text.name;
    return "";
}

const char* typeName(PropertyType type) {
    switch (type) {
    case PropertyType::Number: return "number";
    case PropertyType::Integer: return "integer";
    case PropertyType::Boolean: return "boolean";
    case PropertyType::Choice: return "choice";
    case PropertyType::Text: return "text";
    case PropertyType::File: return "file";
    case PropertyType::Reference: return "reference";
    }
    return "";
}

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : between) + word;
    return text;
}

/// A default in the text's unit without the rounding error of the conversion: 90, not 90.00000000000001.
double inTextUnit(const Property& property, double si) {
    const double value = property.scale != 0 ? si / property.scale : si;
    return std::isfinite(value) ? std::strtod(shortText(value, 15).c_str(), nullptr) : value;
}

std::string defaultText(const Property& property) {
    const PropertyValue& value = *property.defaultValue;
    std::vector<std::string> parts = value.texts;
    for (const double number : value.numbers)
        parts.push_back(property.type == PropertyType::Boolean ? (number != 0 ? "true" : "false")
                                                               : exactText(inTextUnit(property, number)));
    return joined(parts, ",");
}

std::string rangeText(const Property& property) {
    std::vector<std::string> parts;
    const bool low = std::isfinite(property.minimum), high = std::isfinite(property.maximum);
    if (low && high && !property.minExclusive && !property.maxExclusive)
        return exactText(property.minimum) + " to " + exactText(property.maximum);
    if (low) parts.push_back((property.minExclusive ? "above " : "at least ") + exactText(property.minimum));
    if (high) parts.push_back((property.maxExclusive ? "below " : "at most ") + exactText(property.maximum));
    return joined(parts, ", ");
}

std::string countOf(const Property& property) {
    if (property.minCount == property.maxCount) return property.maxCount == 1 ? "" : std::to_string(property.maxCount) + " ";
    if (property.maxCount >= 100000)
        return property.minCount == 0 ? "any number of " : std::to_string(property.minCount) + " or more ";
    return std::to_string(property.minCount) + " to " + std::to_string(property.maxCount) + " ";
}

/// "number in m, above 0, default 0.05"
std::string meaningText(const Property& property) {
    const bool many = property.maxCount != 1;
    std::string text = countOf(property);
    switch (property.type) {
    case PropertyType::Number: text += many ? "numbers" : "number"; break;
    case PropertyType::Integer: text += many ? "whole numbers" : "whole number"; break;
    case PropertyType::Boolean: text += "true or false"; break;
    case PropertyType::Choice: text += "one of " + joined(property.choices, " "); break;
    case PropertyType::Text: text += many ? "texts" : "text"; break;
    case PropertyType::File:
        text += "file" + (property.choices.empty() ? "" : " (" + joined(property.choices, ", ") + ")");
        break;
    case PropertyType::Reference:
        text += std::string(many ? "names of " : "name of a ") + joined(property.choices, " or ");
        break;
    }
    if (!property.unit.empty()) text += " in " + property.unit;
    if (property.type == PropertyType::Number || property.type == PropertyType::Integer)
        if (const std::string range = rangeText(property); !range.empty()) text += ", " + range;
    if (property.required) text += ", required";
    if (property.defaultValue && property.defaultValue->count() > 0) {
        const std::string value = defaultText(property);
        if (!value.empty()) text += ", default " + value;
    }
    if (property.live) text += ", may change during a run";
    return text;
}

const char* directionText(std::uint32_t direction) {
    return direction == TRUNDLE_COMMAND ? "command" : direction == TRUNDLE_TRUTH ? "truth" : "output";
}

std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.append(width - text.size(), ' ');
    return text + "  ";
}

std::string placeText(const Kind& kind) {
    std::vector<std::string> places;
    for (const std::string& parent : allowedParents(kind)) places.push_back(parent.empty() ? "the top level" : parent);
    return places.empty() ? "" : "Allowed in " + joined(places, ", ") + ".";
}

Json numberJson(double number) { return std::isfinite(number) ? Json(number) : Json(nullptr); }

Json propertyJson(const Property& property) {
    Json json{{"name", property.name}, {"type", typeName(property.type)}, {"unit", property.unit}, {"help", property.help}};
    json["required"] = property.required;
    json["live"] = property.live;
    json["choices"] = property.choices;
    json["minimum"] = numberJson(property.minimum);
    json["maximum"] = numberJson(property.maximum);
    json["min_exclusive"] = property.minExclusive;
    json["max_exclusive"] = property.maxExclusive;
    json["min_count"] = property.minCount;
    json["max_count"] = property.maxCount;
    Json values = nullptr;
    if (property.defaultValue) {
        values = Json::array();
        for (const double number : property.defaultValue->numbers) {
            if (property.type == PropertyType::Boolean) values.push_back(number != 0);
            else values.push_back(numberJson(inTextUnit(property, number)));
        }
        for (const std::string& text : property.defaultValue->texts) values.push_back(text);
    }
    json["default"] = std::move(values);
    return json;
}

} // namespace

std::string manualList(const std::vector<const Kind*>& kinds) {
    std::size_t width = 0;
    for (const Kind* kind : kinds) width = std::max(width, kind->name.size());
    std::string text;
    for (const RoleText& role : kRoles) {
        std::string lines;
        for (const Kind* kind : kinds)
            if (kind->role == role.role) lines += "  " + padded(kind->name, width) + kind->help + "\n";
        if (!lines.empty()) text += (text.empty() ? "" : "\n") + std::string(role.title) + "\n" + lines;
    }
    return text;
}

std::string manualPage(const Kind& kind) {
    std::string text = kind.name + " (" + roleWord(kind.role) + ")\n";
    if (!kind.help.empty()) text += kind.help + "\n";
    if (const std::string place = placeText(kind); !place.empty()) text += place + "\n";
    if (!kind.module.empty()) text += "From the module " + std::filesystem::path(kind.module).filename().string() + ".\n";

    std::size_t width = 0;
    for (const Property& property : kind.properties) width = std::max(width, property.name.size());
    for (const SignalDescription& signal : kind.signals) width = std::max(width, signal.name.size());
    if (!kind.properties.empty()) text += "\nProperties\n";
    for (const Property& property : kind.properties) {
        text += "  " + padded(property.name, width) + meaningText(property) + "\n";
        if (!property.help.empty()) text += "  " + padded("", width) + property.help + "\n";
    }
    for (const Alternatives& a : kind.alternatives) text += "  Exactly one of " + joined(a.names, ", ") + " is given.\n";
    if (!kind.signals.empty()) text += "\nSignals\n";
    for (const SignalDescription& signal : kind.signals) {
        text += "  " + padded(signal.name, width) + directionText(signal.direction);
        if (!signal.countFields.empty()) text += ", " + joined(signal.countFields, " x ") + " numbers";
        else if (signal.count > 1) text += ", " + std::to_string(signal.count) + " numbers";
        if (!signal.unit.empty()) text += " in " + signal.unit;
        text += "\n";
        if (!signal.help.empty()) text += "  " + padded("", width) + signal.help + "\n";
    }
    return text;
}

Json manualJson(const Kind& kind) {
    Json json{{"name", kind.name},
              {"role", roleWord(kind.role)},
              {"help", kind.help},
              {"parents", allowedParents(kind)},
              {"module", kind.module}};
    json["properties"] = Json::array();
    for (const Property& property : kind.properties) json["properties"].push_back(propertyJson(property));
    json["exactly_one_of"] = Json::array();
    for (const Alternatives& a : kind.alternatives) json["exactly_one_of"].push_back(a.names);
    json["signals"] = Json::array();
    for (const SignalDescription& signal : kind.signals) {
        const char* type = signal.type == TRUNDLE_BOOLEAN_SIGNAL   ? "boolean"
                           : signal.type == TRUNDLE_INTEGER_SIGNAL ? "integer"
                                                                   : "number";
        json["signals"].push_back({{"name", signal.name},
                                   {"type", type},
                                   {"count", signal.count},
                                   {"unit", signal.unit},
                                   {"direction", directionText(signal.direction)},
                                   {"help", signal.help}});
        if (!signal.countFields.empty()) json["signals"].back()["count_fields"] = signal.countFields;
    }
    return json;
}

} // namespace trundle
