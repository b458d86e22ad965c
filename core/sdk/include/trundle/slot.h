// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <trundle/abi.h>

namespace trundle {
// Types used only by modules and devices are in an inline namespace of their own, so that the program may have classes with the
// same names. Code still writes trundle::Slot; the number is the ABI's major version.
inline namespace sdk1 {

/// A duration or a point in time, s.
struct Seconds {
    double value = 0;
    constexpr operator double() const { return value; }
};

/// One signal of one robot: `count` doubles in the robot's signal image. An unbound slot reads 0 and ignores writes.
class Slot {
public:
    Slot() = default;
    explicit Slot(double* first, std::uint32_t count = 1) : m_first(first), m_count(first ? count : 0) {}

    [[nodiscard]] bool bound() const { return m_first != nullptr; }
    [[nodiscard]] std::uint32_t count() const { return m_count; }
    [[nodiscard]] double get(std::uint32_t element = 0) const { return element < m_count ? m_first[element] : 0.0; }
    /// All of its values, in the robot's image (since 1.6).
    [[nodiscard]] std::span<const double> values() const { return {m_first, m_count}; }
    void set(double value) { set(0, value); }
    void set(std::uint32_t element, double value) {
        if (element < m_count) m_first[element] = value;
    }
    /// For commands: the value written by a controller, or 0 if it is infinite or NaN.
    [[nodiscard]] double finite() const {
        const double v = get();
        return std::isfinite(v) ? v : 0.0;
    }

private:
    double* m_first = nullptr;
    std::uint32_t m_count = 0;
};

/// Type and count of a signal whose value is a V: double, bool, an integer, or a std::array of one of them.
template <class V> struct SignalValue {
    static_assert(std::is_arithmetic_v<V>, "a signal is a number, an integer, a bool or a std::array of one of them");
    static constexpr std::uint32_t type = std::is_same_v<V, bool> ? TRUNDLE_BOOLEAN_SIGNAL
                                          : std::is_integral_v<V> ? TRUNDLE_INTEGER_SIGNAL
                                                                  : TRUNDLE_REAL_SIGNAL;
    static constexpr std::uint32_t count = 1;
};
template <class V, std::size_t N> struct SignalValue<std::array<V, N>> {
    static constexpr std::uint32_t type = SignalValue<V>::type, count = N;
};

/// Since 1.6. As many numbers as fields of the device say, which describe() names.
template <class V> struct SignalValue<std::vector<V>> {
    static constexpr std::uint32_t type = SignalValue<V>::type, count = SignalValue<V>::count; ///< since 1.10 also of std::array
};

// Since 1.5: the members that describe() binds to signals. V is described; values are always passed as doubles.

/// A signal that controllers and other devices write and its device reads.
template <class V> class CommandSlot : public Slot {
public:
    CommandSlot() = default;
    CommandSlot(Slot slot, const char* name) : Slot(slot), m_name(name) {}

    /// The commanded value as its device should read it; `world` is the Actuation or Sensing. An infinite or NaN value counts as
    /// 0 and is reported once.
    template <class World> [[nodiscard]] double read(const World& world) {
        const double value = get();
        if (std::isfinite(value)) [[likely]]
            return value;
        if (!m_reported) report(world);
        return 0;
    }

private:
    /// Not inline, so that read() is small.
    template <class World> [[gnu::noinline]] void report(const World& world) {
        m_reported = true;
        world.warn(std::string(m_name) + " was given a value that is no finite number; it counts as 0");
    }

    bool m_reported = false; // first, in what the base leaves of its last word
    const char* m_name = "";
};

/// A signal that its device or controller sets: 0 until then, and kept until it is set again.
template <class V> class OutputSlot : public Slot {
public:
    OutputSlot() = default;
    OutputSlot(Slot slot, const char*) : Slot(slot) {}
};

/// Ground truth that its device sets for logs and plots; ports do not read it.
template <class V> class TruthSlot : public Slot {
public:
    TruthSlot() = default;
    TruthSlot(Slot slot, const char*) : Slot(slot) {}
};

} // namespace sdk1
} // namespace trundle
