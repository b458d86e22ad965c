#include "model/amount.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "base/units.h"
#include "model/literals.h"
#include "schema/value_words.h"

namespace trundle {
namespace {

double sine(double degrees) {
    const double quarters = degrees / 90;
    if (quarters == std::nearbyint(quarters) && std::abs(quarters) < 1e15) {
        static const double exact[] = {0, 1, 0, -1};
        return exact[((static_cast<long long>(quarters) % 4) + 4) % 4];
    }
    return std::sin(degrees * std::numbers::pi / 180);
}

const std::set<std::string_view> kComparisons{"<", ">", "<=", ">=", "==", "!="};

const std::set<std::string_view> kWithoutUnit{"floor", "ceil", "round", "asin", "acos"};

std::string hasUnit(const std::string& function, const std::string& unit) {
    std::string message = function + " takes a number without unit, this is in " + unit;
    if (function.starts_with('a')) return message;
    return message + "; divide by the step: " + function + "(x / 1 " + unit + ") * 1 " + unit;
}

/// The angle of a sine or cosine in degrees; nothing for other functions and where there is no such angle.
std::optional<double> arc(const std::string& function, double value) {
    constexpr double kRounding = 1e-12; // a quotient of computed lengths may be just above 1
    if ((function != "asin" && function != "acos") || std::abs(value) > 1 + kRounding) return std::nullopt;
    const double exact = std::clamp(value, -1.0, 1.0);
    return (function == "asin" ? std::asin(exact) : std::acos(exact)) * 180 / std::numbers::pi;
}

std::optional<double> wholeNumber(const std::string& function, double value) {
    if (function == "floor") return std::floor(value);
    if (function == "ceil") return std::ceil(value);
    if (function == "round") return std::round(value);
    return std::nullopt;
}

Error fault(std::string message) { return {Code::ExpressionValue, std::move(message)}; }

Result<Amount> finite(Amount amount) {
    if (std::isfinite(amount.value)) return amount;
    return fault("the result is not a number that can be used");
}

bool differ(const Amount& a, const Amount& b) { return !a.unit.empty() && !b.unit.empty() && a.unit != b.unit; }

Error notComparable(const Amount& a, const Amount& b) { return fault(a.unit + " and " + b.unit + " cannot be compared"); }

Result<Amount> extreme(const std::string& function, std::span<const Amount> arguments) {
    if (arguments.empty()) return fault(function + " takes at least one number");
    Amount best = arguments[0];
    for (const Amount& a : arguments) {
        if (differ(a, best)) return notComparable(best, a);
        if (function == "min" ? a.value < best.value : a.value > best.value) best.value = a.value;
        if (best.unit.empty()) best.unit = a.unit;
    }
    return best;
}

bool holds(const std::string& comparison, double a, double b) {
    if (comparison == "<") return a < b;
    if (comparison == ">") return a > b;
    if (comparison == "<=") return a <= b;
    if (comparison == ">=") return a >= b;
    return comparison == "==" ? a == b : a != b;
}

Result<Amount> ofTwo(const std::string& function, const Amount& a, const Amount& b) {
    if (differ(a, b)) return notComparable(a, b);
    if (function == "atan2") return Amount{std::atan2(a.value, b.value) * 180 / std::numbers::pi, "deg"};
    if (function != "mod") return Amount{holds(function, a.value, b.value) ? 1.0 : 0.0, {}};
    if (b.value == 0) return fault("division by zero");
    const double rest = std::fmod(a.value, b.value); // with the sign of b, so that angles wrap
    return Amount{rest != 0 && (rest < 0) != (b.value < 0) ? rest + b.value : rest, a.unit.empty() ? b.unit : a.unit};
}

Result<Amount> trigonometric(const std::string& function, const Amount& a) {
    if (!a.unit.empty() && a.unit != "deg") return fault(function + " takes an angle in degrees, this is in " + a.unit);
    if (function == "sin") return Amount{sine(a.value), {}};
    if (function == "cos") return Amount{sine(a.value + 90), {}};
    if (sine(a.value + 90) == 0) return fault("the tangent of " + numberText(a.value) + " degrees is not a number");
    return Amount{sine(a.value) / sine(a.value + 90), {}};
}

Result<Amount> ofOne(const std::string& function, const Amount& a) {
    if (function == "abs") return Amount{std::abs(a.value), a.unit};
    if (kWithoutUnit.contains(function) && !a.unit.empty()) return fault(hasUnit(function, a.unit));
    if (const auto whole = wholeNumber(function, a.value)) return Amount{*whole, {}};
    if (const auto degrees = arc(function, a.value)) return Amount{*degrees, "deg"};
    if (function == "asin" || function == "acos") return fault(function + " of " + numberText(a.value) + " is not a number");
    if (function != "sqrt") return trigonometric(function, a);
    if (a.value < 0) return fault("the square root of " + numberText(a.value) + " is not a number");
    return Amount{std::sqrt(a.value), {}};
}

} // namespace

Amount inBaseUnit(double number, const std::string& written) {
    const UnitInfo* unit = findUnit(written);
    if (!unit) return {number, {}};
    if (written == "%") return {number * unit->factor, {}};
    const std::string base = baseUnit(unit->dimension);
    return {convertUnit(number, written, base).value_or(number), base};
}

Result<Amount> combined(Expression::Op op, const Amount& a, const Amount& b) {
    using Op = Expression::Op;
    switch (op) {
    case Op::Add:
    case Op::Subtract:
        if (differ(a, b)) return fault(a.unit + " and " + b.unit + " cannot be added");
        return finite({op == Op::Add ? a.value + b.value : a.value - b.value, a.unit.empty() ? b.unit : a.unit});
    case Op::Multiply:
        // the product of two units is treated as a plain number: its dimension is not checked
        return finite({a.value * b.value, a.unit.empty() ? b.unit : b.unit.empty() ? a.unit : std::string()});
    case Op::Divide:
        if (b.value == 0) return fault("division by zero");
        return finite({a.value / b.value, b.unit.empty() ? a.unit : std::string()});
    default: return finite({std::pow(a.value, b.value), {}});
    }
}

std::span<const std::string> functionNames() {
    static const std::string names[] = {"min",  "max", "abs",   "sqrt", "sin",   "cos",   "tan", "asin",
                                        "acos", "mod", "floor", "ceil", "round", "atan2", "if",  "element"};
    return names;
}

bool isComparison(std::string_view function) { return kComparisons.contains(function); }

Result<Amount> applied(const std::string& function, std::span<const Amount> arguments) {
    if (function == "min" || function == "max") return extreme(function, arguments);
    const bool takesTwo = function == "mod" || function == "atan2" || isComparison(function);
    if (takesTwo && arguments.size() == 2) return ofTwo(function, arguments[0], arguments[1]);
    if (arguments.size() != 1) return fault(function + " takes " + (takesTwo ? "two numbers" : "one number"));
    return ofOne(function, arguments[0]);
}

} // namespace trundle
