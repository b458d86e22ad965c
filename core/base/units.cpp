#include "base/units.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace trundle {
namespace {

constexpr double kPi = std::numbers::pi;

// The first unit of each dimension has factor 1; help texts use this order.
constexpr UnitInfo kUnits[] = {
    {"m", "length", 1},
    {"cm", "length", 0.01},
    {"mm", "length", 0.001},
    {"km", "length", 1000},
    {"um", "length", 1e-6},
    {"kg", "mass", 1},
    {"g", "mass", 0.001},
    {"s", "time", 1},
    {"ms", "time", 0.001},
    {"us", "time", 1e-6},
    {"min", "time", 60},
    {"h", "time", 3600},
    {"rad", "angle", 1},
    {"deg", "angle", kPi / 180},
    {"N", "force", 1},
    {"mN", "force", 0.001},
    {"kN", "force", 1000},
    {"Nm", "torque", 1},
    {"mNm", "torque", 0.001},
    {"V", "voltage", 1},
    {"mV", "voltage", 0.001},
    {"A", "current", 1},
    {"mA", "current", 0.001},
    {"ohm", "resistance", 1},
    {"mohm", "resistance", 0.001},
    {"kohm", "resistance", 1000},
    {"H", "inductance", 1},
    {"mH", "inductance", 0.001},
    {"uH", "inductance", 1e-6},
    {"W", "power", 1},
    {"mW", "power", 0.001},
    {"kW", "power", 1000},
    {"J", "energy", 1},
    {"degC", "temperature", 1},
    {"K/W", "thermal resistance", 1},
    {"C", "charge", 1},
    {"Ah", "charge", 3600},
    {"mAh", "charge", 3.6},
    {"Hz", "frequency", 1},
    {"kHz", "frequency", 1e3},
    {"MHz", "frequency", 1e6},
    {"GHz", "frequency", 1e9},
    {"dB", "ratio in dB", 1},
    {"dBm", "power in dBm", 1},
    {"dBi", "antenna gain in dBi", 1},
    {"m/s", "speed", 1},
    {"cm/s", "speed", 0.01},
    {"mm/s", "speed", 0.001},
    {"km/h", "speed", 1 / 3.6},
    {"rad/s", "rate", 1},
    {"deg/s", "rate", kPi / 180},
    {"rpm", "rate", kPi / 30},
    {"m/s^2", "acceleration", 1},
    {"cm/s^2", "acceleration", 0.01},
    {"mm/s^2", "acceleration", 0.001},
    {"rad/s^2", "angular acceleration", 1},
    {"deg/s^2", "angular acceleration", kPi / 180},
    {"m/N", "softness", 1},
    {"mm/N", "softness", 0.001},
    {"N/m", "stiffness", 1},
    {"N/mm", "stiffness", 1000},
    {"Ns/m", "damping", 1},
    {"Nm/rad", "angular stiffness", 1},
    {"Nm/deg", "angular stiffness", 180 / kPi},
    {"Nms/rad", "angular damping", 1},
    {"Nms/deg", "angular damping", 180 / kPi},
    {"Nm/A", "torque constant", 1},
    {"mNm/A", "torque constant", 0.001},
    {"rad/s/V", "speed constant", 1},
    {"rpm/V", "speed constant", kPi / 30},
    {"Vs/rad", "back-EMF constant", 1},
    {"V/rpm", "back-EMF constant", 30 / kPi},
    {"V/rad", "voltage per angle", 1},
    {"kgm^2", "inertia", 1},
    {"gcm^2", "inertia", 1e-7},
    {"kg/m^3", "density", 1},
    {"g/cm^3", "density", 1000},
    {"m^2", "area", 1},
    {"cm^2", "area", 1e-4},
    {"mm^2", "area", 1e-6},
    {"m^3", "volume", 1},
    {"cm^3", "volume", 1e-6},
    {"mm^3", "volume", 1e-9},
    {"bit/s", "bit rate", 1},
    {"kbit/s", "bit rate", 1e3},
    {"Mbit/s", "bit rate", 1e6},
    {"cd", "luminous intensity", 1},
    {"lx", "illuminance", 1},
    {"ppm", "share in ppm", 1},
    {"%", "fraction", 0.01},
};

constexpr std::string_view kBases[] = {"m", "kg", "s", "A", "K", "rad"};

struct Dimension {
    std::string_view name; ///< as in kUnits
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
    {"voltage per angle", {2, 1, -3, -1, 0, -1}},
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

/// Between a product of units, in SI, and a unit that it may be, or the reverse.
std::optional<double> convertProduct(double value, std::string_view from, std::string_view to) {
    const std::optional<UnitExponents> a = exponentsOf(from), b = exponentsOf(to);
    if (from.empty() || to.empty() || !a || !b || !isSameQuantity(*a, *b)) return std::nullopt;
    const UnitInfo *known = findUnit(from), *wanted = findUnit(to);
    return value * (known ? known->factor : 1) / (wanted ? wanted->factor : 1);
}

} // namespace

const UnitInfo* findUnit(std::string_view name) {
    const auto it = std::find_if(std::begin(kUnits), std::end(kUnits), [&](const UnitInfo& u) { return u.name == name; });
    return it == std::end(kUnits) ? nullptr : &*it;
}

std::vector<std::string> allUnitNames() {
    std::vector<std::string> names;
    for (const UnitInfo& unit : kUnits) names.emplace_back(unit.name);
    return names;
}

double wholeIfRounded(double value) {
    constexpr double kRounding = 1e-12;
    const double whole = std::nearbyint(value);
    return std::abs(value - whole) <= kRounding * std::max(1.0, std::abs(whole)) ? whole : value;
}

std::optional<double> convertUnit(double value, std::string_view from, std::string_view to) {
    if (from == to) return value; // also without units on both sides; avoids rounding
    const UnitInfo* a = findUnit(from);
    // A percentage is a fraction of one: 50 % is 0.5 where no unit is expected.
    if (a && to.empty() && a->dimension == "fraction") return value * a->factor;
    const UnitInfo* b = findUnit(to);
    if (!a || !b) return convertProduct(value, from, to);
    if (a->dimension != b->dimension) return std::nullopt;
    // Divide by factors below 1: 3 cm is 3 / 100 m, the double nearest to 0.03, whereas 3 * 0.01 is the double next to it.
    const double ratio = a->factor / b->factor;
    const double inverse = b->factor / a->factor;
    if (ratio < 1 && inverse == static_cast<double>(static_cast<long long>(inverse))) return value / inverse;
    return value * ratio;
}

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
        const bool perAngle = d.name == "voltage per angle" && exponents[kRadian] == 0; // it is a voltage
        alike += isSameQuantity(d.exponents, exponents) && !perAngle;
        if (d.exponents == exponents) exact = &d;
    }
    return exact && alike == 1 ? firstUnit(exact->name) : productOf(exponents);
}

bool isSameQuantity(const UnitExponents& a, const UnitExponents& b) { return std::equal(a.begin(), a.begin() + kRadian, b.begin()); }

} // namespace trundle
