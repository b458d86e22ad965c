#include "schema/value_words.h"

#include <charconv>
#include <cmath>

#include "base/spelling.h"

namespace trundle {

namespace {

constexpr std::uint32_t kMany = 1000; ///< a larger maxCount means unlimited

std::string plural(PropertyType type, bool many) {
    switch (type) {
    case PropertyType::Number: return many ? "numbers" : "number";
    case PropertyType::Integer: return many ? "whole numbers" : "whole number";
    case PropertyType::Boolean: return "true or false";
    case PropertyType::Choice: return many ? "words" : "word";
    case PropertyType::Text: return many ? "texts" : "text";
    case PropertyType::File: return many ? "file names" : "file name";
    case PropertyType::Reference: return many ? "names" : "name";
    }
    return {};
}

/// For reading: 200000, where the shortest text is 2e+05.
std::string readableText(double value) {
    if (std::abs(value) >= 1e15 || value != std::floor(value)) return numberText(value);
    char buffer[40];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, value == 0 ? 0.0 : value, std::chars_format::fixed).ptr};
}

std::string countWord(std::uint32_t count) {
    static const char* const words[] = {"no", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    return count < std::size(words) ? words[count] : std::to_string(count);
}

} // namespace

std::string numberText(double value) {
    if (value == 0) return "0";
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    return {buffer, end};
}

std::string elementText(const GivenElement& element) {
    switch (element.kind) {
    case GivenElement::Kind::Number: return readableText(element.number) + (element.unit.empty() ? "" : " " + element.unit);
    case GivenElement::Kind::Boolean: return element.boolean ? "true" : "false";
    default: return element.text.size() > 60 ? element.text.substr(0, 57) + "..." : element.text;
    }
}

std::string limitText(const Property& p) {
    const auto amount = [&](double limit) { return readableText(limit) + (limit == 0 || p.unit.empty() ? "" : " " + p.unit); };
    const bool low = std::isfinite(p.minimum), high = std::isfinite(p.maximum);
    if (low && high && !p.minExclusive && !p.maxExclusive) {
        return "from " + readableText(p.minimum) + " to " + amount(p.maximum);
    }
    std::string text;
    if (low) text = (p.minExclusive ? "above " : "at least ") + amount(p.minimum);
    if (low && high) text += " and ";
    if (high) text += (p.maxExclusive ? "below " : "at most ") + amount(p.maximum);
    return text;
}

std::string brokenLimitText(const Property& p, double value) {
    const bool closed = std::isfinite(p.minimum) && std::isfinite(p.maximum) && !p.minExclusive && !p.maxExclusive;
    if (closed || !std::isfinite(value)) return limitText(p);
    Property side = p;
    if (p.minExclusive ? value <= p.minimum : value < p.minimum) side.maximum = HUGE_VAL;
    else side.minimum = -HUGE_VAL;
    return limitText(side);
}

std::string listText(std::span<const std::string> words, std::string_view last, std::size_t most) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i) {
        if (i == most && words.size() > most + 1) return text + " ... (" + std::to_string(words.size()) + " in all)";
        if (i > 0) text += i + 1 == words.size() ? " " + std::string(last) + " " : ", ";
        text += words[i];
    }
    return text;
}

std::string countText(const Property& p) {
    const std::string one = p.type == PropertyType::Boolean ? "true or false" : withArticle(plural(p.type, false));
    if (p.minCount == 1 && p.maxCount == 1) return one;
    if (p.minCount == p.maxCount) return countWord(p.minCount) + " " + plural(p.type, true);
    if (p.maxCount > kMany) return (p.minCount <= 1 ? "one" : countWord(p.minCount)) + " or more " + plural(p.type, true);
    return countWord(p.minCount) + " to " + countWord(p.maxCount) + " " + plural(p.type, true);
}

std::string withArticle(std::string_view word) {
    const bool spokenYou = word.starts_with("Uni") || word.starts_with("uni"); // pronounced with a consonant: a Universal
    const bool vowel = !spokenYou && !word.empty() && std::string_view("aeiouAEIOU").find(word[0]) != std::string_view::npos;
    return (vowel ? "an " : "a ") + std::string(word);
}

void suggestWords(Diagnostic& diagnostic, std::vector<std::string> words, SourceRange range) {
    if (words.empty()) return;
    if (range.known()) diagnostic.fixes.push_back({words.front(), {{range, words.front()}}});
    diagnostic.suggestions = std::move(words);
}

void suggest(Diagnostic& diagnostic, std::string_view word, std::span<const std::string> candidates, SourceRange range) {
    suggestWords(diagnostic, nearestWords(word, candidates), range);
}

} // namespace trundle
