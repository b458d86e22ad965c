#include "project/objects/value_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "schema/value_words.h"

namespace trundle {
namespace {

constexpr std::string_view kMinus = "\xE2\x88\x92"; ///< U+2212

std::string escaped(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '\n') out += "\\n";
        else if (c == '"' || c == '\\') out += {'\\', c};
        else out += c;
    }
    return out + "\"";
}

const Value* firstList(const std::vector<Item>& items) {
    for (const Item& item : items) {
        if (const auto* a = item.as<AssignmentItem>(); a && a->value.elements.size() > 1) return &a->value;
        if (const auto* block = item.as<BlockItem>())
            if (const Value* found = firstList(block->items)) return found;
    }
    return nullptr;
}

/// A limit of a range: 0.001, 1000, 1e-6, 1e9.
std::string brief(double limit) {
    const double size = std::abs(limit);
    if (limit == 0 || (size >= 1e-4 && size < 1e5)) return plainNumber(limit);
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.6g", limit);
    std::string text = buffer;
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    std::size_t digits = e + 2;
    while (digits + 1 < text.size() && text[digits] == '0') text.erase(digits, 1);
    if (text[e + 1] == '+') text.erase(e + 1, 1);
    return text;
}

} // namespace

std::string tidied(std::string text) {
    for (std::size_t at = text.find(kMinus); at != std::string::npos; at = text.find(kMinus))
        text.replace(at, kMinus.size(), "-");
    const std::size_t first = text.find_first_not_of(" \t\r\n");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1);
}

ParsedValue withArithmetic(const std::string& text, bool onlyNumbers) {
    const ParsedValue typed(text);
    const std::vector<Element>& elements = typed.value().elements;
    const bool isWord = elements.size() == 1 && elements[0].kind == Element::Kind::Word;
    const bool isArithmetic = !typed.status() || (onlyNumbers && isWord && text.find_first_of("+-*/") != std::string::npos);
    if (!isArithmetic) return typed;
    const ParsedValue formula("$(" + text + ")");
    return formula.status() ? formula : typed;
}

ParsedValue wordOrQuoted(const std::string& text, bool quoted) {
    const ParsedValue typed(text);
    const bool asTyped = text.starts_with("$") || (text.size() > 1 && text.starts_with("\"") && text.ends_with("\""));
    if (asTyped && typed.status()) return typed;
    const std::vector<Element>& elements = typed.value().elements;
    const bool isWord = elements.size() == 1 && elements[0].kind == Element::Kind::Word && elements[0].text == text;
    return isWord && !quoted ? typed : ParsedValue(escaped(text));
}

ParsedValue listOfWords(const std::string& text) {
    if (const ParsedValue typed(text); typed.status()) return typed;
    std::string out, element;
    bool quoted = false;
    const auto finish = [&] {
        const std::string word = tidied(element);
        out += (out.empty() ? "" : ",") + (word.empty() ? word : wordOrQuoted(word, false).text());
        element.clear();
    };
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '"' && (i == 0 || text[i - 1] != '\\')) quoted = !quoted;
        if (text[i] == ',' && !quoted) finish();
        else element += text[i];
    }
    finish();
    return out;
}

std::string plainText(std::string_view element) {
    const ParsedValue value(element);
    const std::vector<Element>& elements = value.value().elements;
    return elements.size() == 1 && elements[0].kind == Element::Kind::String ? elements[0].text : std::string(element);
}

std::string plainNumber(double value) {
    if (value == 0) return "0";
    const double size = std::abs(value);
    char buffer[64];
    const bool plain = size >= 1e-6 && size < 1e15;
    const auto end = plain ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed).ptr
                           : std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

std::string numberOf(const Property& property, double si) {
    const double value = si / property.scale;
    // 90 degrees converted from radians are 90.00000000000001
    const double near = std::round(value * 1e9) / 1e9;
    const bool same = property.scale != 1 && std::abs(near - value) <= 1e-12 * std::max(1.0, std::abs(value));
    return plainNumber(same ? near : value);
}

std::vector<std::string> elementsOf(const Property& property, const PropertyValue& value) {
    std::vector<std::string> elements;
    for (const double n : value.numbers)
        elements.push_back(property.type == PropertyType::Boolean ? (n != 0 ? "true" : "false") : numberOf(property, n));
    for (const std::string& t : value.texts) elements.push_back(wordOrQuoted(t, false).text());
    return elements;
}

std::string joined(const std::vector<std::string>& elements, std::string_view separator) {
    std::string text;
    for (std::size_t i = 0; i < elements.size(); ++i) {
        if (i > 0) text += separator;
        text += elements[i];
    }
    return text;
}

std::string separatorOf(const Tree& tree) {
    const Value* list = firstList(tree.items());
    if (!list) return ",";
    const std::string_view between = tree.source().slice({list->elements[0].range.end, list->elements[1].range.begin});
    return between == ", " ? ", " : ",";
}

std::string rounded(double value) {
    char buffer[40];
    std::snprintf(buffer, sizeof buffer, "%.6g", value == 0 ? 0.0 : value);
    return buffer;
}

std::string unitAndRange(const Property& p) {
    std::string text = p.unit;
    if (!isNumeric(p)) return text;
    const bool low = std::isfinite(p.minimum), high = std::isfinite(p.maximum);
    if (!text.empty() && (low || high)) text += ", ";
    if (low && high && !p.minExclusive && !p.maxExclusive) return text + "from " + brief(p.minimum) + " to " + brief(p.maximum);
    if (low) text += (p.minExclusive ? "above " : "at least ") + brief(p.minimum);
    if (low && high) text += ", ";
    if (high) text += (p.maxExclusive ? "below " : "at most ") + brief(p.maximum);
    return text;
}

bool isNumeric(const Property& property) {
    return property.type == PropertyType::Number || property.type == PropertyType::Integer;
}

bool isColour(const Property& property) {
    return property.type == PropertyType::Number && property.unit.empty() && property.minCount == 3 && property.maxCount == 3 &&
           property.minimum == 0 && property.maximum == 1;
}

} // namespace trundle
