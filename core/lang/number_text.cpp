#include "lang/number_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <vector>

#include "base/units.h"
#include "lang/characters.h"
#include "lang/parsed_value.h"

namespace trundle {
namespace {

bool usesIndex(const Expression& e) {
    return (e.op == Expression::Op::Name && (e.name == "index" || e.name == "index2")) ||
           std::ranges::any_of(e.arguments, [](const Expression& argument) { return usesIndex(argument); });
}

/// Whether it has another value in each member of a Repeat.
bool usesIndex(const Element& e) {
    if (e.kind == Element::Kind::ParamRef) return e.text == "index" || e.text == "index2";
    return e.kind == Element::Kind::Expression && e.expression && usesIndex(*e.expression);
}

bool isFormula(const Element& e) { return e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression; }

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && isBlank(text.front())) text.remove_prefix(1);
    while (!text.empty() && isBlank(text.back())) text.remove_suffix(1);
    return text;
}

/// `$(0.1*index)` with a number added: `$(0.1*index + 0.05)`. One that is added there already is changed.
std::string plusNumber(std::string_view text, const Element& old, double number, double step) {
    std::string_view body = old.text; // `$index`
    if (const Expression* sum = old.expression.get()) {
        body = trimmed(text.substr(2, text.size() - 3));
        const bool isSum = sum->op == Expression::Op::Add || sum->op == Expression::Op::Subtract;
        const std::size_t size = isSum ? sum->arguments[1].range.size() : 0;
        const std::string_view last = body.substr(body.size() - size);
        double added = 0;
        if (const auto [end, error] = std::from_chars(last.data(), last.data() + last.size(), added);
            isSum && error == std::errc() && end == last.data() + last.size()) {
            number += sum->op == Expression::Op::Add ? added : -added;
            body = trimmed(body.substr(0, body.size() - size));
            body = trimmed(body.substr(0, body.size() - 1));
        }
    }
    const std::string amount = steppedNumber(std::abs(number), step);
    return "$(" + std::string(body) + (amount == "0" ? "" : (number < 0 ? " - " : " + ") + amount) + ")";
}

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
        const std::string old = text.substr(range.begin, range.size());
        result += same                     ? old
                  : usesIndex(elements[i]) ? plusNumber(old, elements[i], after[i] - before[i], step)
                                           : elementText(text, elements[i], after[i], unit, step);
        done = range.end;
    }
    return result + text.substr(done);
}

std::vector<std::string> replacedFormulas(const std::string& before, const std::string& after) {
    const ParsedValue old(before), now(after);
    const std::vector<Element>&from = old.value().elements, &to = now.value().elements;
    std::vector<std::string> formulas;
    for (std::size_t i = 0; i < from.size(); ++i)
        if (isFormula(from[i]) && (from.size() != to.size() || !isFormula(to[i])))
            formulas.push_back(before.substr(from[i].range.begin, from[i].range.size()));
    return formulas;
}

} // namespace trundle
