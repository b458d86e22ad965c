#pragma once
#include <cstdint>
#include <string>

namespace trundle {

/// The shortest text that parses to the same number.
[[nodiscard]] std::string exactText(double number);
/// With a fixed number of decimals; never "-0.00".
[[nodiscard]] std::string fixedText(double number, int digits);
/// With the given number of significant digits, without trailing zeros: 857, 0.0142.
[[nodiscard]] std::string shortText(double number, int digits = 3);
/// "3 ticks", "1 tick".
[[nodiscard]] std::string counted(std::uint64_t count, const std::string& noun);

} // namespace trundle
