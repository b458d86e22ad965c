#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Damerau-Levenshtein distance (optimal string alignment), letters compared with case; a change of case alone costs less.
[[nodiscard]] double spellingDistance(std::string_view a, std::string_view b);
/// The candidates near enough to be what was meant, best first, at most `most`. Ties in the candidates' order.
[[nodiscard]] std::vector<std::string> nearestWords(std::string_view word, std::span<const std::string> candidates,
                                                    std::size_t most = 3);

} // namespace trundle
