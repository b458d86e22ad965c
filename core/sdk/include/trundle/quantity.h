// SPDX-License-Identifier: BSD-2-Clause
#pragma once
// The unit, limits and flags of a field.

#include <limits>
#include <numbers>

#include <trundle/abi.h>

namespace trundle {

/// Unit and limits of a field. The class receives numbers in SI units; limits are given in the text's unit.
struct Quantity {
    const char* unit = "";
    double scale = 1;
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    unsigned flags = 0;
    const char* choices = "";
    unsigned type = 0;                   ///< 0: from the member's C++ type
    unsigned minCount = 0, maxCount = 0; ///< 0: from the member's C++ type

    [[nodiscard]] constexpr Quantity within(double low, double high) const {
        Quantity q = *this;
        q.minimum = low;
        q.maximum = high;
        return q;
    }
    [[nodiscard]] constexpr Quantity atLeast(double low) const {
        Quantity q = *this;
        q.minimum = low;
        return q;
    }
    [[nodiscard]] constexpr Quantity above(double low) const {
        Quantity q = atLeast(low);
        q.flags |= TRUNDLE_MIN_EXCLUSIVE;
        return q;
    }
    [[nodiscard]] constexpr Quantity atMost(double high) const {
        Quantity q = *this;
        q.maximum = high;
        return q;
    }
    [[nodiscard]] constexpr Quantity below(double high) const {
        Quantity q = atMost(high);
        q.flags |= TRUNDLE_MAX_EXCLUSIVE;
        return q;
    }
    [[nodiscard]] constexpr Quantity required() const {
        Quantity q = *this;
        q.flags |= TRUNDLE_REQUIRED;
        return q;
    }
    /// May be changed during a run, with immediate effect.
    [[nodiscard]] constexpr Quantity live() const {
        Quantity q = *this;
        q.flags |= TRUNDLE_LIVE;
        return q;
    }
    [[nodiscard]] constexpr Quantity counted(unsigned low, unsigned high) const {
        Quantity q = *this;
        q.minCount = low;
        q.maxCount = high;
        return q;
    }
};

constexpr Quantity unitOf(const char* unit, double scale = 1) {
    Quantity q;
    q.unit = unit;
    q.scale = scale;
    return q;
}

constexpr Quantity number() { return {}; }
constexpr Quantity metres() { return unitOf("m"); }
constexpr Quantity kilograms() { return unitOf("kg"); }
constexpr Quantity seconds() { return unitOf("s"); }
constexpr Quantity milliseconds() { return unitOf("ms", 1e-3); }
constexpr Quantity degrees() { return unitOf("deg", std::numbers::pi / 180); } ///< radians in the class
constexpr Quantity newtons() { return unitOf("N"); }
constexpr Quantity newtonMetres() { return unitOf("Nm"); }
constexpr Quantity metresPerSecond() { return unitOf("m/s"); }
constexpr Quantity metresPerSecondSquared() { return unitOf("m/s^2"); }
constexpr Quantity radiansPerSecond() { return unitOf("rad/s"); }
constexpr Quantity radiansPerSecondSquared() { return unitOf("rad/s^2"); }
constexpr Quantity volts() { return unitOf("V"); }
constexpr Quantity amperes() { return unitOf("A"); }
constexpr Quantity ohms() { return unitOf("ohm"); }
constexpr Quantity hertz() { return unitOf("Hz"); }
constexpr Quantity decibels() { return unitOf("dB"); }
constexpr Quantity decibelMilliwatts() { return unitOf("dBm"); }

constexpr Quantity flag() { return {}; }
constexpr Quantity text() { return {}; }
/// One of the words in "servo|pi|voltage".
constexpr Quantity oneOf(const char* choices) {
    Quantity q;
    q.choices = choices;
    q.type = TRUNDLE_CHOICE;
    return q;
}
/// A file with one of the extensions "png|jpg".
constexpr Quantity file(const char* endings) {
    Quantity q;
    q.choices = endings;
    q.type = TRUNDLE_FILE;
    return q;
}
/// The name of an object of one of the kinds or roles "Hinge|Slider".
constexpr Quantity reference(const char* kinds) {
    Quantity q;
    q.choices = kinds;
    q.type = TRUNDLE_REFERENCE;
    return q;
}

} // namespace trundle
