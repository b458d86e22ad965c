#pragma once
// Wording of values, limits and lists in messages.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/diagnostic.h"
#include "schema/given_value.h"
#include "schema/kind.h"

namespace trundle {

/// The shortest text that parses to the same number.
[[nodiscard]] std::string numberText(double value);
/// "-3 cm", "fast", "true".
[[nodiscard]] std::string elementText(const GivenElement& element);
/// "above 0", "from 0 to 1", "at least 0.5 m"; empty if there is no limit.
[[nodiscard]] std::string limitText(const Property& property);
/// The limit that `value` (in the property's unit) violates, or both limits where they form a range: "from 0 to 1".
[[nodiscard]] std::string brokenLimitText(const Property& property, double value);
/// "a, b or c"; truncated with "..." after `most` words.
[[nodiscard]] std::string listText(std::span<const std::string> words, std::string_view last = "or", std::size_t most = 12);
/// "a number", "three numbers", "one or more words".
[[nodiscard]] std::string countText(const Property& property);
/// "a", "an".
[[nodiscard]] std::string withArticle(std::string_view word);

/// Adds suggestions (nearest first) and, for the best one, a fix that replaces `range` by it.
void suggest(Diagnostic& diagnostic, std::string_view word, std::span<const std::string> candidates, SourceRange range);
/// Like suggest(), for words already selected.
void suggestWords(Diagnostic& diagnostic, std::vector<std::string> words, SourceRange range);

} // namespace trundle
