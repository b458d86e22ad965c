#pragma once
#include <span>
#include <string>

namespace trundle {

/// As few digits as say the number to the nearest multiple of `step` (1e-6, 0.01 ...): "0.35", "-1.5", never "-0".
[[nodiscard]] std::string steppedNumber(double value, double step);

/// A value's text with other numbers in it. Elements whose number stays keep their characters, formulas too; the others keep
/// the unit they were written with, and what stands between elements stays. `text` holds `before` in `unit` ("m", "deg");
/// where it is empty or something else, plain numbers take its place.
[[nodiscard]] std::string withNumbers(const std::string& text, std::span<const double> before, std::span<const double> after,
                                      const char* unit, double step);

} // namespace trundle
