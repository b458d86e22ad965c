#include "lang/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "lang/parsed_value.h"

namespace trundle {
namespace {

std::string elementText(const std::string& text, const Element& old, double value, const char* unit, double step) {
    if (old.kind != Element::Kind::Number || old.unit.empty()) return steppedNumber(value, step);
    const auto converted = convertUnit(value, unit, old.unit), one = convertUnit(1, unit, old.unit);
    if (!converted || !one) return steppedNumber(value, step);
    // The number as written ends before its unit and any space before the unit.
    std::size_t end = old.unitRange.begin;
    while (end > old.range.begin && text[end - 1] == ' ') --end;
    return steppedNumber(*converted, std::min(1.0, step * *one)) + text.substr(end, old.range.end - end);
}

} // namespace

std::string steppedNumber(double value, double step) {
    const int decimals = std::clamp(static_cast<int>(std::ceil(-std::log10(std::clamp(step, 1e-12, 1.0)) - 1e-9)), 0, 12);
    char digits[400];
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals);
    std::string text(digits, end.ptr);
    if (text.find('.') != std::string::npos) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    return text == "-0" ? "0" : text;
}

std::string withNumbers(const std::string& text, std::span<const double> before, std::span<const double> after, const char* unit,
                        double step) {
    const ParsedValue parsed(text);
    const std::vector<Element>& elements = parsed.value().elements;
    std::string result;
    if (elements.size() != after.size() || before.size() != after.size()) {
        for (const double value : after) result += (result.empty() ? "" : ",") + steppedNumber(value, step);
        return result;
    }
    std::size_t done = 0;
    for (std::size_t i = 0; i < after.size(); ++i) {
        const TextRange& range = elements[i].range;
        result += text.substr(done, range.begin - done);
        const bool same = std::abs(after[i] - before[i]) < 0.5 * std::min(step, 1e-6);
        result += same ? text.substr(range.begin, range.size()) : elementText(text, elements[i], after[i], unit, step);
        done = range.end;
    }
    return result + text.substr(done);
}

} // namespace trundle
