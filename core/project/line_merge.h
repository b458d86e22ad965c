#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Lines [begin, end) of one text that are lines [from, to) of another, counted from 0.
struct LineHunk {
    int begin = 0, end = 0, from = 0, to = 0;
};
/// What differs between two texts, in order; hunks never touch.
[[nodiscard]] std::vector<LineHunk> lineHunks(std::string_view before, std::string_view after);

/// Two descendants of one text, put together line by line. Nothing where their changes touch: the same line, or lines side by side.
/// A change that both made alike is one change.
[[nodiscard]] std::optional<std::string> mergedByLines(std::string_view base, std::string_view mine, std::string_view theirs);

} // namespace trundle
