#include "cli/numbers.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

namespace trundle {

std::string exactText(double number) {
    char digits[64];
    return {digits, std::to_chars(digits, digits + sizeof digits, number).ptr};
}

std::string fixedText(double number, int digits) {
    if (std::fabs(number) < 0.5 * std::pow(10.0, -digits)) number = 0;
    char text[400];
    std::snprintf(text, sizeof text, "%.*f", digits, number);
    return text;
}

std::string shortText(double number, int digits) {
    char text[64];
    // Large numbers are written without an exponent: 1230000, not 1.23e+06.
    std::snprintf(text, sizeof text, "%.*e", digits - 1, number);
    const double rounded = std::strtod(text, nullptr);
    if (std::fabs(rounded) >= std::pow(10.0, digits) && std::fabs(rounded) < 1e14) return fixedText(rounded, 0);
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace trundle
