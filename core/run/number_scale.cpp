#include "run/number_scale.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <string_view>

namespace trundle {
namespace {

constexpr int kMaxDecimals = 3;
constexpr double kLeast = 5e-4; // a smaller one has no digit anyway
constexpr double kSmall = 0.1; // smaller values are shown with the prefix milli

/// Units that take a prefix. Lengths and speeds are always in metres, as in the language.
bool takesPrefix(std::string_view unit) {
    constexpr std::array<std::string_view, 9> kUnits{"V", "A", "W", "N", "N m", "J", "Hz", "Pa", "ohm"};
    return std::ranges::find(kUnits, unit) != kUnits.end();
}

} // namespace

NumberScale::NumberScale(std::string unit, Kind kind) : m_unit(std::move(unit)), m_kind(kind) { choose(); }

void NumberScale::note(double value) {
    const double size = std::abs(value);
    if (!(size > m_largest) || !std::isfinite(size)) return;
    m_largest = size;
    choose();
}

void NumberScale::choose() {
    m_factor = 1;
    m_shownUnit = m_unit;
    if (m_unit == "rad") {
        m_factor = 180 / std::numbers::pi;
        m_shownUnit = "°";
    } else if (takesPrefix(m_unit)) {
        const bool none = m_largest == 0;
        const auto scaled = [&](double factor, const char* prefix) {
            m_factor = factor;
            m_shownUnit = prefix + m_unit;
        };
        if (!none && m_largest < kSmall) scaled(1e3, "m");
        else if (m_largest >= 1e6) scaled(1e-6, "M");
        else if (m_largest >= 1e4) scaled(1e-3, "k");
    }
    const double shown = m_largest * m_factor;
    const int lead = shown >= 10 ? static_cast<int>(std::floor(std::log10(shown))) : 0;
    m_decimals = m_kind == Kind::Whole ? 0 : std::clamp(kMaxDecimals - lead, m_unit == "m" ? 3 : 0, kMaxDecimals);
}

std::string NumberScale::text(double value) const {
    if (std::isnan(value)) return "not a number";
    if (std::isinf(value)) return value > 0 ? "infinite" : "-infinite";
    // One value far above the others would leave nothing of them.
    const double shown = std::abs(value * m_factor);
    int decimals = m_decimals;
    if (m_kind == Kind::Real && shown >= kLeast && shown * std::pow(10, decimals) < 0.5)
        while (decimals < kMaxDecimals && shown * std::pow(10, decimals) < 10) ++decimals;
    char digits[400];
    std::snprintf(digits, sizeof digits, "%.*f", decimals, value * m_factor);
    const std::string_view written(digits);
    // "-0.00" is shown without the sign.
    if (written.front() == '-' && written.find_first_not_of("-0.") == std::string_view::npos)
        return std::string(written.substr(1));
    return std::string(written);
}

} // namespace trundle
