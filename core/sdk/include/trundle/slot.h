// SPDX-License-Identifier: BSD-2-Clause
#pragma once
#include <cmath>
#include <cstdint>

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

} // namespace sdk1
} // namespace trundle
