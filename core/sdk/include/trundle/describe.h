// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The single description of a kind: its fields and signals. Parser, range checks, property rows, completion, hover texts and the
// manual are generated from it. The default of a field is the member's value in a default-constructed object.

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <trundle/quantity.h>

namespace trundle {

/// A described field, with the closure that sets it in an object.
struct FieldInfo {
    std::string name, unit, help, choices;
    double scale = 1, minimum = 0, maximum = 0;
    std::uint32_t type = 0, minCount = 1, maxCount = 1, flags = 0;
    std::vector<double> defaultNumbers; ///< SI
    std::vector<std::string> defaultTexts;
    std::function<void(void*, const TrundleValue&)> set;
};

struct SignalInfo {
    std::string name, unit, help;
    std::uint32_t type = TRUNDLE_REAL_SIGNAL, count = 1, direction = TRUNDLE_OUTPUT;
};

/// Fields of which exactly one must be given. If all are missing, the value of field `likely` is suggested for the last one.
struct AlternativesInfo {
    std::string names; ///< separated by '|'
    std::string likely;
};

namespace detail {

inline constexpr std::uint32_t kManyElements = 100000;

/// Conversion between a member type and TrundleValue.
template <class M> struct Member;

template <> struct Member<double> {
    static constexpr std::uint32_t type = TRUNDLE_NUMBER, low = 1, high = 1;
    static void get(const double& m, FieldInfo& f) { f.defaultNumbers = {m}; }
    static void set(double& m, const TrundleValue& v) { m = v.numbers[0]; }
};
template <class I>
requires(std::is_integral_v<I> && !std::is_same_v<I, bool>) struct Member<I> {
    static constexpr std::uint32_t type = TRUNDLE_INTEGER, low = 1, high = 1;
    static void get(const I& m, FieldInfo& f) { f.defaultNumbers = {static_cast<double>(m)}; }
    static void set(I& m, const TrundleValue& v) { m = static_cast<I>(v.numbers[0]); }
};
template <> struct Member<bool> {
    static constexpr std::uint32_t type = TRUNDLE_BOOLEAN, low = 1, high = 1;
    static void get(const bool& m, FieldInfo& f) { f.defaultNumbers = {m ? 1.0 : 0.0}; }
    static void set(bool& m, const TrundleValue& v) { m = v.numbers[0] != 0; }
};
template <> struct Member<std::string> {
    static constexpr std::uint32_t type = TRUNDLE_TEXT, low = 1, high = 1;
    static void get(const std::string& m, FieldInfo& f) { f.defaultTexts = {m}; }
    static void set(std::string& m, const TrundleValue& v) { m = v.texts[0]; }
};
template <std::size_t N> struct Member<std::array<double, N>> {
    static constexpr std::uint32_t type = TRUNDLE_NUMBER, low = N, high = N;
    static void get(const std::array<double, N>& m, FieldInfo& f) { f.defaultNumbers.assign(m.begin(), m.end()); }
    static void set(std::array<double, N>& m, const TrundleValue& v) {
        for (std::size_t i = 0; i < N; ++i) m[i] = v.numbers[i];
    }
};
template <> struct Member<std::vector<double>> {
    static constexpr std::uint32_t type = TRUNDLE_NUMBER, low = 0, high = kManyElements;
    static void get(const std::vector<double>& m, FieldInfo& f) { f.defaultNumbers = m; }
    static void set(std::vector<double>& m, const TrundleValue& v) { m.assign(v.numbers, v.numbers + v.count); }
};
template <> struct Member<std::vector<std::string>> {
    static constexpr std::uint32_t type = TRUNDLE_TEXT, low = 0, high = kManyElements;
    static void get(const std::vector<std::string>& m, FieldInfo& f) { f.defaultTexts = m; }
    static void set(std::vector<std::string>& m, const TrundleValue& v) { m.assign(v.texts, v.texts + v.count); }
};
/// Stays empty if missing in the text.
template <class M> struct Member<std::optional<M>> {
    static constexpr std::uint32_t type = Member<M>::type, low = Member<M>::low, high = Member<M>::high;
    static void get(const std::optional<M>& m, FieldInfo& f) {
        if (m) Member<M>::get(*m, f);
        else f.flags |= TRUNDLE_OPTIONAL;
    }
    static void set(std::optional<M>& m, const TrundleValue& v) {
        M value{};
        Member<M>::set(value, v);
        m = std::move(value);
    }
};

} // namespace detail

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
        m_fields.push_back(std::move(f));
        return *this;
    }

    /// Requires exactly one of these fields ("A|B", all std::optional) in the text.
    Describe& exactlyOneOf(std::string names, std::string likely = {}) {
        m_alternatives.push_back({std::move(names), std::move(likely)});
        return *this;
    }

    /// A signal published by the device or controller: 0 until it is set.
    Describe& output(std::string name, std::string unit, std::string help, std::uint32_t count = 1,
                     std::uint32_t type = TRUNDLE_REAL_SIGNAL) {
        m_signals.push_back({std::move(name), std::move(unit), std::move(help), type, count, TRUNDLE_OUTPUT});
        return *this;
    }
    /// A signal available only in simulation (ground truth), for logs and plots; controllers read it only through groundTruth
    /// ports.
    Describe& truth(std::string name, std::string unit, std::string help, std::uint32_t count = 1) {
        m_signals.push_back({std::move(name), std::move(unit), std::move(help), TRUNDLE_REAL_SIGNAL, count, TRUNDLE_TRUTH});
        return *this;
    }
    /// A signal written by controllers and other devices.
    Describe& command(std::string name, std::string unit, std::string help, std::uint32_t count = 1,
                      std::uint32_t type = TRUNDLE_REAL_SIGNAL) {
        m_signals.push_back({std::move(name), std::move(unit), std::move(help), type, count, TRUNDLE_COMMAND});
        return *this;
    }

    [[nodiscard]] const std::string& helpText() const { return m_help; }
    [[nodiscard]] const std::vector<FieldInfo>& fields() const { return m_fields; }
    [[nodiscard]] const std::vector<SignalInfo>& signals() const { return m_signals; }
    [[nodiscard]] const std::vector<AlternativesInfo>& alternatives() const { return m_alternatives; }

private:
    T m_default{};
    std::string m_help;
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
