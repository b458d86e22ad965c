#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Damerau-Levenshtein distance (optimal string alignment), case-sensitive; a difference in case alone costs less.
[[nodiscard]] double spellingDistance(std::string_view a, std::string_view b);
/// The candidates close enough to be the intended word, best first, at most `most`. Ties keep the candidates' order.
[[nodiscard]] std::vector<std::string> nearestWords(std::string_view word, std::span<const std::string> candidates,
                                                    std::size_t most = 3);

} // namespace trundle
