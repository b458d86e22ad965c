#pragma once
// A kind of object with its properties and allowed parents, copied from the output of its describe() function.

#include <cstdint>
#include <string>
#include <vector>

#include <trundle/describe.h>

namespace trundle {

enum class PropertyType { Number, Integer, Boolean, Choice, Text, File, Reference };

/// A resolved value: numbers in SI units, texts for choices, strings, files and references.
struct PropertyValue {
    PropertyType type = PropertyType::Number;
    std::vector<double> numbers; ///< Number, Integer, Boolean (0 or 1)
    std::vector<std::string> texts;

    [[nodiscard]] std::size_t count() const { return numbers.size() + texts.size(); }
    bool operator==(const PropertyValue&) const = default;
};

struct Property {
    std::string name, unit, help;
    PropertyType type = PropertyType::Number;
    std::vector<std::string> choices; ///< Choice: words; File: extensions; Reference: kinds or roles
    double scale = 1;                 ///< factor from the text's unit to SI
    double minimum = 0, maximum = 0;  ///< in the text's unit
    bool minExclusive = false, maxExclusive = false, required = false, live = false;
    std::uint32_t minCount = 1, maxCount = 1;
    std::optional<PropertyValue> defaultValue; ///< none: required, or a missing value means "not given"
};

struct SignalDescription {
    std::string name, unit, help;
    std::uint32_t type = TRUNDLE_REAL_SIGNAL, count = 1, direction = TRUNDLE_OUTPUT;
    std::vector<std::string> countFields = {}; ///< integer properties; `count` is multiplied by their values
};

/// Properties of which exactly one must be given.
struct Alternatives {
    std::vector<std::string> names;
    std::string likely; ///< property whose value the last of them most likely has; empty: none
};

enum class Role {
    Settings,
    Material,
    Surface,
    Pattern, ///< radiation pattern of an antenna
    Medium,  ///< the air through which radios transmit
    Config,
    Instance,
    Layout,
    Repeat, ///< blocks of a config that are there several times
    Body,
    Geom,
    Joint,
    Device,
    Controller,
    Log,
    Look,  ///< lights, sky and views
    Region ///< a box that reports what is inside
};

struct Kind {
    std::string name, help;
    Role role = Role::Device;
    std::vector<std::string> parents; ///< allowed parent kinds; "" is the top level
    bool nameOptional = false;        ///< geoms, logs: numbered by default, `box`, `box2` ...
    std::vector<Property> properties;
    std::vector<SignalDescription> signals;
    std::string module; ///< path of the library that provides it; empty: built in
    std::vector<Alternatives> alternatives;

    [[nodiscard]] const Property* find(std::string_view property) const;
};

[[nodiscard]] Property propertyFrom(const FieldInfo& field);
[[nodiscard]] SignalDescription signalFrom(const SignalInfo& signal);
[[nodiscard]] Alternatives alternativesFrom(const AlternativesInfo& alternatives);

/// The Kind of a class with a static describe().
template <class T> Kind kindOf(std::string name, Role role, std::vector<std::string> parents, bool nameOptional = false) {
    const Describe<T>& d = descriptionOf<T>();
    Kind kind{std::move(name), d.helpText(), role, std::move(parents), nameOptional, {}, {}, {}, {}};
    for (const FieldInfo& f : d.fields()) kind.properties.push_back(propertyFrom(f));
    for (const SignalInfo& s : d.signals()) kind.signals.push_back(signalFrom(s));
    for (const AlternativesInfo& a : d.alternatives()) kind.alternatives.push_back(alternativesFrom(a));
    return kind;
}

} // namespace trundle
