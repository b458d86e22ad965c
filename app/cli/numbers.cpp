#include "cli/numbers.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdio>

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
    if (number != 0 && std::isfinite(number)) {
        // Large numbers are written without an exponent: 1230000, not 1.23e+06.
        const double size = std::floor(std::log10(std::fabs(number))) + 1;
        if (size > digits && size < 15) {
            const double unit = std::pow(10.0, size - digits);
            return fixedText(std::round(number / unit) * unit, 0);
        }
    }
    char text[64];
    std::snprintf(text, sizeof text, "%.*g", digits, number);
    return text;
}

std::string counted(std::uint64_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

} // namespace trundle
