#include "model/amount.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

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
    if (function == "floor") return std::floor(wholeIfRounded(value));
    if (function == "ceil") return std::ceil(wholeIfRounded(value));
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

/// The value of `a` as one in `unit`: a plain number beside a rate counts in rad/s, as in a property.
double valueIn(const std::string& unit, const Amount& a) {
    const UnitInfo* info = a.unit.empty() ? findUnit(unit) : nullptr;
    return info ? convertUnit(a.value, plainUnit(info->dimension), unit).value_or(a.value) : a.value;
}

/// An amount in SI, but in degrees where there are angles, so that quarter turns stay exact.
struct Product {
    double value = 1;
    UnitExponents exponents{};
};

constexpr double kDegrees = 180 / std::numbers::pi;

double factorOf(const std::string& unit) {
    const UnitInfo* info = findUnit(unit);
    return info ? info->factor : 1;
}

std::optional<Product> productFrom(const Amount& a) {
    const std::optional<UnitExponents> exponents = exponentsOf(a.unit);
    if (!exponents) return std::nullopt;
    const bool isInDegrees = a.unit.starts_with("deg");
    return Product{isInDegrees ? a.value : a.value * factorOf(a.unit) * std::pow(kDegrees, (*exponents)[kRadian]), *exponents};
}

Amount amountOf(const Product& product) {
    const std::string unit = unitOfProduct(product.exponents);
    const UnitInfo* info = findUnit(unit);
    const std::string base = info ? baseUnit(info->dimension) : unit;
    if (base.starts_with("deg")) return {product.value, base};
    return {product.value * std::pow(kDegrees, -product.exponents[kRadian]) / factorOf(base), base};
}

/// a times b to the power of `power`, 1 or -1.
Result<Amount> product(const Amount& a, const Amount& b, int power) {
    std::optional<Product> left = productFrom(a);
    const std::optional<Product> right = productFrom(b);
    if (!left || !right) return fault((left ? b : a).unit + " cannot be multiplied or divided with units");
    left->value = power > 0 ? left->value * right->value : left->value / right->value;
    for (std::size_t i = 0; i < left->exponents.size(); ++i) left->exponents[i] += power * right->exponents[i];
    return finite(amountOf(*left));
}

Result<Amount> sum(const Amount& a, const Amount& b, double sign) {
    const std::string& unit = a.unit.empty() ? b.unit : a.unit;
    if (!differ(a, b)) return finite({valueIn(unit, a) + sign * valueIn(unit, b), unit});
    const std::optional<double> other = convertUnit(b.value, b.unit, a.unit); // torque and a product of force and length
    if (!other) return fault(a.unit + " and " + b.unit + " cannot be added");
    return finite({a.value + sign * *other, a.unit});
}

Result<Amount> raised(const Amount& a, double power) {
    const auto raise = [power](double value) { return power == 0.5 ? std::sqrt(value) : std::pow(value, power); };
    if (a.unit.empty()) return finite({raise(a.value), {}});
    std::optional<Product> all = productFrom(a);
    if (all &&
        all->exponents[kRadian] * power != std::nearbyint(all->exponents[kRadian] * power)) // angles are plain numbers there
        all->value *= std::pow(kDegrees, -std::exchange(all->exponents[kRadian], 0));
    for (std::size_t i = 0; all && i < all->exponents.size(); ++i) {
        const double exponent = all->exponents[i] * power;
        if (exponent != std::nearbyint(exponent) || std::abs(exponent) > 20) all.reset();
        else all->exponents[i] = static_cast<int>(exponent);
    }
    if (!all) return fault(a.unit + " to the power of " + numberText(power) + " is not a unit");
    all->value = raise(all->value);
    return finite(amountOf(*all));
}

Result<Amount> extreme(const std::string& function, std::span<const Amount> arguments) {
    if (arguments.empty()) return fault(function + " takes at least one number");
    Amount best = arguments[0];
    for (const Amount& a : arguments) {
        if (differ(a, best)) return notComparable(best, a);
        if (best.unit.empty()) best = {valueIn(a.unit, best), a.unit};
        const double value = valueIn(best.unit, a);
        if (function == "min" ? value < best.value : value > best.value) best.value = value;
    }
    return best;
}

/// Numbers that differ by rounding are equal: 0.1 * 3 == 0.3.
bool holds(const std::string& comparison, double a, double b) {
    const bool equal = std::abs(a - b) <= kUnitRounding * std::max(std::abs(a), std::abs(b));
    if (comparison == "==" || comparison == "!=") return equal == (comparison == "==");
    if (equal) return comparison.size() == 2; // <=, >=
    return (a < b) == (comparison[0] == '<');
}

Result<Amount> ofTwo(const std::string& function, const Amount& first, const Amount& second) {
    if (differ(first, second)) return notComparable(first, second);
    const std::string unit = first.unit.empty() ? second.unit : first.unit;
    const Amount a{valueIn(unit, first), unit}, b{valueIn(unit, second), unit};
    if (function == "atan2") return Amount{std::atan2(a.value, b.value) * 180 / std::numbers::pi, "deg"};
    if (function != "mod") return Amount{holds(function, a.value, b.value) ? 1.0 : 0.0, {}};
    if (b.value == 0) return fault("division by zero");
    const double rest = std::fmod(a.value, b.value); // with the sign of b, so that angles wrap
    return Amount{rest != 0 && (rest < 0) != (b.value < 0) ? rest + b.value : rest, unit};
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
    return raised(a, 0.5);
}

} // namespace

Amount inBaseUnit(double number, const std::string& written) {
    const UnitInfo* unit = findUnit(written);
    if (!unit) return {number, exponentsOf(written) ? written : std::string()};
    if (written == "%") return {number * unit->factor, {}};
    const std::string base = baseUnit(unit->dimension);
    return {convertUnit(number, written, base).value_or(number), base};
}

Result<Amount> combined(Expression::Op op, const Amount& a, const Amount& b) {
    using Op = Expression::Op;
    switch (op) {
    case Op::Add:
    case Op::Subtract:
        return sum(a, b, op == Op::Add ? 1 : -1);
    case Op::Multiply:
        if (a.unit.empty() || b.unit.empty()) return finite({a.value * b.value, a.unit.empty() ? b.unit : a.unit});
        return product(a, b, 1);
    case Op::Divide:
        if (b.value == 0) return fault("division by zero");
        if (b.unit.empty()) return finite({a.value / b.value, a.unit});
        return product(a, b, -1);
    default:
        if (!b.unit.empty()) return fault("an exponent has no unit, this is in " + b.unit);
        return raised(a, b.value);
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
