#pragma once
// Numbers with units in expressions, and what can be computed with them.

#include <span>
#include <string>
#include <string_view>

#include "base/result.h"
#include "lang/tree.h"

namespace trundle {

/// A number in an expression, in the base unit of its dimension: m, deg, deg/s ...
struct Amount {
    double value = 0;
    std::string unit; ///< empty: a plain number
};

[[nodiscard]] Amount inBaseUnit(double number, const std::string& written);

/// a + b, a - b, a * b, a / b, a ^ b.
[[nodiscard]] Result<Amount> combined(Expression::Op op, const Amount& a, const Amount& b);

/// The functions of expressions, for messages. `if` and `element` are evaluated where Params are known.
[[nodiscard]] std::span<const std::string> functionNames();
[[nodiscard]] bool isComparison(std::string_view function);
/// A function or comparison of numbers.
[[nodiscard]] Result<Amount> applied(const std::string& function, std::span<const Amount> arguments);

} // namespace trundle
