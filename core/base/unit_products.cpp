#include "base/unit_products.h"

#include <algorithm>
#include <charconv>

#include "base/units.h"

namespace trundle {
namespace {

constexpr std::string_view kBases[] = {"m", "kg", "s", "A", "K", "rad"};

struct Dimension {
    std::string_view name; ///< of units.cpp
    UnitExponents exponents;
};

constexpr Dimension kDimensions[] = {
    {"length", {1, 0, 0, 0, 0, 0}},
    {"mass", {0, 1, 0, 0, 0, 0}},
    {"time", {0, 0, 1, 0, 0, 0}},
    {"angle", {0, 0, 0, 0, 0, 1}},
    {"force", {1, 1, -2, 0, 0, 0}},
    {"torque", {2, 1, -2, 0, 0, 0}},
    {"voltage", {2, 1, -3, -1, 0, 0}},
    {"current", {0, 0, 0, 1, 0, 0}},
    {"resistance", {2, 1, -3, -2, 0, 0}},
    {"inductance", {2, 1, -2, -2, 0, 0}},
    {"power", {2, 1, -3, 0, 0, 0}},
    {"energy", {2, 1, -2, 0, 0, 0}},
    {"thermal resistance", {-2, -1, 3, 0, 1, 0}},
    {"charge", {0, 0, 1, 1, 0, 0}},
    {"frequency", {0, 0, -1, 0, 0, 0}},
    {"speed", {1, 0, -1, 0, 0, 0}},
    {"rate", {0, 0, -1, 0, 0, 1}},
    {"acceleration", {1, 0, -2, 0, 0, 0}},
    {"angular acceleration", {0, 0, -2, 0, 0, 1}},
    {"softness", {0, -1, 2, 0, 0, 0}},
    {"stiffness", {0, 1, -2, 0, 0, 0}},
    {"damping", {0, 1, -1, 0, 0, 0}},
    {"angular stiffness", {2, 1, -2, 0, 0, -1}},
    {"angular damping", {2, 1, -1, 0, 0, -1}},
    {"torque constant", {2, 1, -2, -1, 0, 0}},
    {"speed constant", {-2, -1, 2, 1, 0, 1}},
    {"back-EMF constant", {2, 1, -2, -1, 0, -1}},
    {"inertia", {2, 1, 0, 0, 0, 0}},
    {"density", {-3, 1, 0, 0, 0, 0}},
    {"area", {2, 0, 0, 0, 0, 0}},
    {"volume", {3, 0, 0, 0, 0, 0}},
};

std::string firstUnit(std::string_view dimension) {
    for (const std::string& name : allUnitNames())
        if (findUnit(name)->dimension == dimension) return name;
    return {};
}

/// "m^2", "kg", "1"
bool addFactor(std::string_view factor, int sign, UnitExponents& sum) {
    if (factor == "1") return true;
    const std::size_t power = factor.find('^');
    int exponent = 1;
    if (power != std::string_view::npos) {
        const char *from = factor.data() + power + 1, *end = factor.data() + factor.size();
        if (std::from_chars(from, end, exponent).ptr != end) return false;
    }
    const auto base = std::ranges::find(kBases, factor.substr(0, power));
    if (base == std::end(kBases)) return false;
    sum[static_cast<std::size_t>(base - std::begin(kBases))] += sign * exponent;
    return true;
}

std::optional<UnitExponents> exponentsOfProduct(std::string_view text) {
    UnitExponents sum{};
    int sign = 1;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find_first_of(" /", from), text.size());
        if (!addFactor(text.substr(from, end - from), sign, sum)) return std::nullopt;
        if (end < text.size()) sign = text[end] == '/' ? -1 : 1;
        from = end + 1;
    }
    return sum;
}

std::string productOf(const UnitExponents& exponents) {
    std::string above, below;
    for (std::size_t i = 0; i < exponents.size(); ++i) {
        const int power = std::abs(exponents[i]);
        if (power == 0) continue;
        const std::string factor = std::string(kBases[i]) + (power == 1 ? "" : "^" + std::to_string(power));
        if (exponents[i] > 0) above += (above.empty() ? "" : " ") + factor;
        else below += "/" + factor;
    }
    return (above.empty() ? "1" : above) + below;
}

} // namespace

std::optional<UnitExponents> exponentsOf(std::string_view unit) {
    if (unit.empty()) return UnitExponents{};
    const UnitInfo* known = findUnit(unit);
    if (!known) return exponentsOfProduct(unit);
    const auto dimension = std::ranges::find(kDimensions, known->dimension, &Dimension::name);
    if (dimension == std::end(kDimensions)) return std::nullopt;
    return dimension->exponents;
}

std::string unitOfProduct(const UnitExponents& exponents) {
    if (exponents == UnitExponents{}) return {};
    const Dimension* exact = nullptr;
    int alike = 0;
    for (const Dimension& d : kDimensions) {
        alike += isSameQuantity(d.exponents, exponents);
        if (d.exponents == exponents) exact = &d;
    }
    return exact && (alike == 1 || exponents[kRadian] != 0) ? firstUnit(exact->name) : productOf(exponents);
}

bool isSameQuantity(const UnitExponents& a, const UnitExponents& b) { return std::equal(a.begin(), a.begin() + kRadian, b.begin()); }

} // namespace trundle
