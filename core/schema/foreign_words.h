#pragma once
// What other simulators and formats call the kinds and properties that have another name here.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// The candidates that a word of another language stands for, best first: `Hinge` for `RevoluteJoint`, `Parent` for `body1`. Small and
/// capital letters and `_` make no difference.
[[nodiscard]] std::vector<std::string> foreignWords(std::string_view word, std::span<const std::string> candidates);
/// The same, or where it stands for none, those spelt alike.
[[nodiscard]] std::vector<std::string> meantWords(std::string_view word, std::span<const std::string> candidates);

} // namespace trundle
