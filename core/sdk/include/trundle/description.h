// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// What describe() collects: fields and signals with the closures that reach their members in an object.

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <trundle/quantity.h>
#include <trundle/slot.h>

namespace trundle {

/// A described field, with the closure that sets it in an object.
struct FieldInfo {
    std::string name, unit, help, choices;
    double scale = 1, minimum = 0, maximum = 0;
    std::uint32_t type = 0, minCount = 1, maxCount = 1, flags = 0;
    std::vector<double> defaultNumbers; ///< SI
    std::vector<std::string> defaultTexts;
    std::function<void(void*, const TrundleValue&)> set;
    std::function<double(const void*)> number = {}; ///< since 1.6: the value in an object; empty unless it is one integer
};

struct SignalInfo {
    std::string name, unit, help;
    std::uint32_t type = TRUNDLE_REAL_SIGNAL, count = 1, direction = TRUNDLE_OUTPUT;
    /// Since 1.5. Binds the member in an object and names it; empty: the signal was described without a member.
    std::function<void(void* object, Slot slot, const char* name)> bind;
    /// Since 1.6. Integer fields of the kind; `count` is multiplied by their values. At most two.
    std::vector<std::string> countFields = {};
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

/// To what a member of a small or unsigned type can hold; any 32-bit integer of a text fits into the others.
template <class I> void limitTo(FieldInfo& f) {
    using Limits = std::numeric_limits<I>;
    if (std::is_unsigned_v<I> || sizeof(I) < sizeof(std::int32_t))
        f.minimum = std::max(f.minimum, double(Limits::min()) / f.scale);
    if (sizeof(I) < sizeof(std::int32_t)) f.maximum = std::min(f.maximum, double(Limits::max()) / f.scale);
}

} // namespace detail

} // namespace trundle
