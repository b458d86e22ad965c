#pragma once
// A kind of object as the rest of the program knows it: copies of what some describe() said, with the places it may stand.

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
    std::vector<std::string> choices; ///< Choice: words; File: endings; Reference: kinds or roles
    double scale = 1;                 ///< text unit to SI
    double minimum = 0, maximum = 0;  ///< in the text's unit
    bool minExclusive = false, maxExclusive = false, required = false, live = false;
    std::uint32_t minCount = 1, maxCount = 1;
    std::optional<PropertyValue> defaultValue; ///< none: required, or absent means "not given"
};

struct SignalDescription {
    std::string name, unit, help;
    std::uint32_t type = TRUNDLE_REAL_SIGNAL, count = 1, direction = TRUNDLE_OUTPUT;
};

/// Properties of which exactly one is given.
struct Alternatives {
    std::vector<std::string> names;
    std::string likely; ///< property whose value the last of them most likely has; empty: nobody knows
};

enum class Role {
    Settings,
    Material,
    Surface,
    Pattern, ///< of an antenna
    Medium,  ///< the air between radios
    Config,
    Instance,
    Layout,
    Body,
    Geom,
    Joint,
    Device,
    Controller,
    Log,
    Look ///< lights, sky and views
};

struct Kind {
    std::string name, help;
    Role role = Role::Device;
    std::vector<std::string> parents; ///< kinds it may stand in; "" is the top level
    bool nameOptional = false;        ///< geoms, logs: `box`, `box2` ... in order
    std::vector<Property> properties;
    std::vector<SignalDescription> signals;
    std::string module; ///< the library that brings it; empty: built in
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
