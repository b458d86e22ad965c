#pragma once
#include <span>
#include <string>
#include <vector>

namespace trundle {

/// The number rounded to a multiple of `step` (1e-6, 0.01 ...) with as few digits as possible: "0.35", "-1.5", never "-0".
[[nodiscard]] std::string steppedNumber(double value, double step);

/// Replaces the numbers in a value's text. Elements with an unchanged number keep their text, including formulas; others keep
/// their unit. A formula with index, which has another value in each member of a Repeat, gets the difference added: `$(0.1*index + 0.05)`.
/// Separators are kept. `text` must contain `before`, expressed in `unit` ("m", "deg"); if it is empty or differs,
/// the result is plain numbers.
[[nodiscard]] std::string withNumbers(const std::string& text, std::span<const double> before, std::span<const double> after,
                                      const char* unit, double step);
/// The formulas of a value, "$gap", "$(2*gap)", that are numbers in the new text of it.
[[nodiscard]] std::vector<std::string> replacedFormulas(const std::string& before, const std::string& after);

} // namespace trundle
