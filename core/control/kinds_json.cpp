#include "control/kinds_json.h"

#include <cmath>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/clean_text.h"
#include "control/module_kinds.h"

namespace trundle {
namespace {

using Json = nlohmann::ordered_json;
constexpr int kFormat = 1;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::pair<PropertyType, const char*> kTypeNames[] = {
    {PropertyType::Number, "number"},      {PropertyType::Integer, "integer"}, {PropertyType::Boolean, "boolean"},
    {PropertyType::Choice, "choice"},      {PropertyType::Text, "text"},       {PropertyType::File, "file"},
    {PropertyType::Reference, "reference"}};
constexpr const char* kSignalTypes[] = {"", "real", "integer", "boolean"};
constexpr const char* kDirections[] = {"", "output", "command", "truth"};

const char* typeName(PropertyType type) {
    for (const auto& [t, name] : kTypeNames)
        if (t == type) return name;
    return "number";
}

PropertyType typeOf(const std::string& name) {
    for (const auto& [type, text] : kTypeNames)
        if (name == text) return type;
    throw std::runtime_error("'" + name + "' is no type of a field");
}

template <std::size_t N> std::uint32_t indexOf(const char* const (&names)[N], const std::string& name) {
    for (std::uint32_t i = 1; i < N; ++i)
        if (name == names[i]) return i;
    throw std::runtime_error("'" + name + "' is no type or direction of a signal");
}

/// JSON has no infinity, so it becomes null.
Json limit(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

Json toJson(const Property& p) {
    Json j{{"name", p.name},
           {"type", typeName(p.type)},
           {"unit", p.unit},
           {"help", p.help},
           {"choices", p.choices},
           {"scale", p.scale},
           {"minimum", limit(p.minimum)},
           {"maximum", limit(p.maximum)},
           {"min_exclusive", p.minExclusive},
           {"max_exclusive", p.maxExclusive},
           {"required", p.required},
           {"live", p.live},
           {"count", {p.minCount, p.maxCount}}};
    if (p.defaultValue && p.defaultValue->texts.empty()) j["default"] = p.defaultValue->numbers;
    else if (p.defaultValue) j["default"] = p.defaultValue->texts;
    return j;
}

Json toJson(const Kind& kind) {
    Json j{{"name", kind.name}, {"role", kind.role == Role::Controller ? "controller" : "device"}, {"help", kind.help}};
    j["fields"] = Json::array();
    for (const Property& p : kind.properties) j["fields"].push_back(toJson(p));
    for (const Alternatives& a : kind.alternatives) j["exactly_one_of"].push_back({{"names", a.names}, {"likely", a.likely}});
    j["signals"] = Json::array();
    for (const SignalDescription& s : kind.signals) {
        j["signals"].push_back({{"name", s.name},
                                {"unit", s.unit},
                                {"help", s.help},
                                {"type", kSignalTypes[s.type]},
                                {"count", s.count},
                                {"direction", kDirections[s.direction]}});
        if (!s.countFields.empty()) j["signals"].back()["count_fields"] = s.countFields;
    }
    return j;
}

PropertyValue valueFrom(const Json& j, PropertyType type) {
    PropertyValue value{type, {}, {}};
    const bool numeric = type == PropertyType::Number || type == PropertyType::Integer || type == PropertyType::Boolean;
    if (numeric) value.numbers = j.get<std::vector<double>>();
    else value.texts = j.get<std::vector<std::string>>();
    return value;
}

Property propertyFromJson(const Json& j) {
    Property p;
    p.name = j.at("name").get<std::string>();
    p.type = typeOf(j.at("type").get<std::string>());
    p.unit = j.at("unit").get<std::string>();
    p.help = cleanText(j.at("help").get<std::string>());
    p.choices = j.at("choices").get<std::vector<std::string>>();
    p.scale = j.at("scale").get<double>();
    p.minimum = j.at("minimum").is_null() ? -kInfinity : j.at("minimum").get<double>();
    p.maximum = j.at("maximum").is_null() ? kInfinity : j.at("maximum").get<double>();
    p.minExclusive = j.at("min_exclusive").get<bool>();
    p.maxExclusive = j.at("max_exclusive").get<bool>();
    p.required = j.at("required").get<bool>();
    p.live = j.at("live").get<bool>();
    p.minCount = j.at("count").at(0).get<std::uint32_t>();
    p.maxCount = j.at("count").at(1).get<std::uint32_t>();
    if (j.contains("default")) p.defaultValue = valueFrom(j.at("default"), p.type);
    return p;
}

Kind kindFromJson(const Json& j, const std::string& library) {
    Kind kind;
    kind.name = j.at("name").get<std::string>();
    kind.help = cleanText(j.at("help").get<std::string>());
    kind.module = library;
    const std::string role = j.at("role").get<std::string>();
    if (role != "controller" && role != "device") throw std::runtime_error("'" + role + "' is no role of a kind");
    kind.role = role == "controller" ? Role::Controller : Role::Device;
    kind.parents = kind.role == Role::Controller ? std::vector<std::string>{"Robot", "Grid", "Scatter"}
                                                 : std::vector<std::string>{"RobotConfig"};
    for (const Json& field : j.at("fields")) kind.properties.push_back(propertyFromJson(field));
    if (j.contains("exactly_one_of"))
        for (const Json& a : j.at("exactly_one_of"))
            kind.alternatives.push_back({a.at("names").get<std::vector<std::string>>(), a.at("likely").get<std::string>()});
    for (const Json& s : j.at("signals"))
        kind.signals.push_back(
            {s.at("name").get<std::string>(), s.at("unit").get<std::string>(), cleanText(s.at("help").get<std::string>()),
             indexOf(kSignalTypes, s.at("type").get<std::string>()), s.at("count").get<std::uint32_t>(),
             indexOf(kDirections, s.at("direction").get<std::string>()), s.value("count_fields", std::vector<std::string>())});
    if (const std::string fault = kindFault(kind); !fault.empty()) throw std::runtime_error("'" + kind.name + "' " + fault);
    return kind;
}

} // namespace

std::string kindsToJson(const std::vector<Kind>& kinds) {
    Json j{{"format", kFormat},
           {"sdk", TRUNDLE_SDK_VERSION},
           {"interface", {TRUNDLE_ABI_MAJOR, TRUNDLE_ABI_MINOR}},
           {"kinds", Json::array()}};
    for (const Kind& kind : kinds) j["kinds"].push_back(toJson(kind));
    return j.dump(2, ' ', false, Json::error_handler_t::replace) + "\n"; // does not throw on invalid UTF-8
}

Result<std::vector<Kind>> kindsFromJson(const std::string& text, const std::string& library) {
    const auto fault = [&](const std::string& why) {
        const bool isPython = library.ends_with(".py"); // which has no such file, and is not built
        return Error{Code::ModuleUndescribed, (isPython ? library : kindsJsonPath(library)) + " cannot be used (" + why + "); " +
                                                  (isPython ? "correct the class in this file" : "build the module again")};
    };
    try { // the JSON library reports errors by exceptions
        const Json j = Json::parse(text, nullptr, false);
        if (j.is_discarded()) return fault("it is damaged");
        if (j.at("format").get<int>() != kFormat) return fault("it has another format");
        std::vector<Kind> kinds;
        for (const Json& kind : j.at("kinds")) kinds.push_back(kindFromJson(kind, library));
        return kinds;
    } catch (const Json::exception&) {
        return fault("it is damaged, or another program has written it");
    } catch (const std::exception& e) { return fault(e.what()); }
}

} // namespace trundle
