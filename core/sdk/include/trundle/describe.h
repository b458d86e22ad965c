// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The single description of a kind: its fields and signals. Parser, range checks, property rows, completion, hover texts and the
// manual are generated from it. The default of a field is the member's value in a default-constructed object.

#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <trundle/description.h>

namespace trundle {

/// Collects the description of a class T; see FieldInfo.
template <class T> class Describe {
public:
    /// Description of the kind in one line.
    Describe& help(std::string text) {
        m_help = std::move(text);
        return *this;
    }

    template <class Owner, class M>
    requires std::is_base_of_v<Owner, T> Describe& field(std::string name, M Owner::*member, const Quantity& q,
                                                         std::string help) {
        using Access = detail::Member<M>;
        FieldInfo f;
        f.name = std::move(name);
        f.help = std::move(help);
        f.unit = q.unit;
        f.choices = q.choices;
        f.scale = q.scale;
        f.minimum = q.minimum;
        f.maximum = q.maximum;
        f.flags = q.flags;
        f.type = q.type ? q.type : Access::type;
        f.minCount = q.maxCount ? q.minCount : Access::low;
        f.maxCount = q.maxCount ? q.maxCount : Access::high;
        if (!(q.flags & TRUNDLE_REQUIRED)) Access::get(m_default.*member, f);
        f.set = [member](void* object, const TrundleValue& v) { Access::set(static_cast<T*>(object)->*member, v); };
        if constexpr (std::is_integral_v<M> && !std::is_same_v<M, bool>) {
            detail::limitTo<M>(f);
            f.number = [member](const void* object) { return static_cast<double>(static_cast<const T*>(object)->*member); };
        }
        m_fields.push_back(std::move(f));
        return *this;
    }

    /// Requires exactly one of these fields ("A|B", all std::optional) in the text.
    Describe& exactlyOneOf(std::string names, std::string likely = {}) {
        m_alternatives.push_back({std::move(names), std::move(likely)});
        return *this;
    }

    /// Since 1.13. Its calls use nothing that robots share but what they may read: no radio, lamps, latches, chargers, moving surfaces, no
    /// global variables of the module. They may then come at the same time as those of other robots.
    Describe& independent() {
        m_traits |= TRUNDLE_INDEPENDENT;
        return *this;
    }

    /// A signal published by the device or controller: 0 until it is set.
    Describe& output(std::string name, std::string unit, std::string help, std::uint32_t count = 1,
                     std::uint32_t type = TRUNDLE_REAL_SIGNAL) {
        m_signals.push_back({std::move(name), std::move(unit), std::move(help), type, count, TRUNDLE_OUTPUT, {}, {}});
        return *this;
    }
    /// A signal available only in simulation (ground truth), for logs and plots; controllers read it only through groundTruth
    /// ports.
    Describe& truth(std::string name, std::string unit, std::string help, std::uint32_t count = 1) {
        m_signals.push_back(
            {std::move(name), std::move(unit), std::move(help), TRUNDLE_REAL_SIGNAL, count, TRUNDLE_TRUTH, {}, {}});
        return *this;
    }
    /// A signal written by controllers and other devices.
    Describe& command(std::string name, std::string unit, std::string help, std::uint32_t count = 1,
                      std::uint32_t type = TRUNDLE_REAL_SIGNAL) {
        m_signals.push_back({std::move(name), std::move(unit), std::move(help), type, count, TRUNDLE_COMMAND, {}, {}});
        return *this;
    }

    // Since 1.5: signals described like fields. The SDK binds the member before setup(), in every object of the kind; type and
    // count come from the member: OutputSlot<bool>, OutputSlot<int>, OutputSlot<std::array<double, 3>>.
    template <class Owner, class V>
    requires std::is_base_of_v<Owner, T> Describe& output(std::string name, OutputSlot<V> Owner::*member, std::string unit,
                                                          std::string help) {
        return addSignal<V>(std::move(name), member, std::move(unit), std::move(help), TRUNDLE_OUTPUT);
    }
    /// Since 1.6. A signal of as many numbers as these integer fields of the device say, multiplied: {"Beams", "Layers"}. At most
    /// two.
    template <class Owner, class V>
    requires std::is_base_of_v<Owner, T> Describe& output(std::string name, OutputSlot<std::vector<V>> Owner::*member,
                                                          std::string unit, std::string help,
                                                          std::vector<std::string> countFields) {
        output(std::move(name), member, std::move(unit), std::move(help));
        m_signals.back().countFields = std::move(countFields);
        return *this;
    }
    template <class Owner, class V>
    requires std::is_base_of_v<Owner, T> Describe& truth(std::string name, TruthSlot<V> Owner::*member, std::string unit,
                                                         std::string help) {
        return addSignal<V>(std::move(name), member, std::move(unit), std::move(help), TRUNDLE_TRUTH);
    }
    /// Since 1.10; as of an output.
    template <class Owner, class V>
    requires std::is_base_of_v<Owner, T> Describe& truth(std::string name, TruthSlot<std::vector<V>> Owner::*member,
                                                         std::string unit, std::string help,
                                                         std::vector<std::string> countFields) {
        truth(std::move(name), member, std::move(unit), std::move(help));
        m_signals.back().countFields = std::move(countFields);
        return *this;
    }
    template <class Owner, class V>
    requires std::is_base_of_v<Owner, T> Describe& command(std::string name, CommandSlot<V> Owner::*member, std::string unit,
                                                           std::string help) {
        return addSignal<V>(std::move(name), member, std::move(unit), std::move(help), TRUNDLE_COMMAND);
    }

    /// Number of values of a signal in an object of T, whose fields are set.
    [[nodiscard]] std::uint32_t countOf(const SignalInfo& signal, const T& object) const {
        double count = signal.count;
        for (const std::string& name : signal.countFields)
            for (const FieldInfo& f : m_fields)
                if (f.name == name && f.number) count *= f.number(&object);
        return count > 0 && count < 4e9 ? static_cast<std::uint32_t>(count) : 0;
    }

    [[nodiscard]] const std::string& helpText() const { return m_help; }
    [[nodiscard]] std::uint32_t traits() const { return m_traits; }
    [[nodiscard]] const std::vector<FieldInfo>& fields() const { return m_fields; }
    [[nodiscard]] const std::vector<SignalInfo>& signals() const { return m_signals; }
    [[nodiscard]] const std::vector<AlternativesInfo>& alternatives() const { return m_alternatives; }

private:
    template <class V, class Owner, class S>
    Describe& addSignal(std::string name, S Owner::*member, std::string unit, std::string help, std::uint32_t direction) {
        m_signals.push_back(
            {std::move(name),
             std::move(unit),
             std::move(help),
             SignalValue<V>::type,
             SignalValue<V>::count,
             direction,
             [member](void* object, Slot slot, const char* called) { static_cast<T*>(object)->*member = S(slot, called); },
             {}});
        return *this;
    }

    T m_default{};
    std::string m_help;
    std::uint32_t m_traits = 0;
    std::vector<FieldInfo> m_fields;
    std::vector<SignalInfo> m_signals;
    std::vector<AlternativesInfo> m_alternatives;
};

/// The description of T, created once.
template <class T> const Describe<T>& descriptionOf() {
    static const Describe<T> description = [] {
        Describe<T> d;
        T::describe(d);
        return d;
    }();
    return description;
}

} // namespace trundle
