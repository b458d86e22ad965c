#pragma once
// Line differences and three-way merge of texts, for files that were changed both here and on disk.
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Lines [begin, end) of one text correspond to lines [from, to) of another, counted from 0.
struct LineHunk {
    int begin = 0, end = 0, from = 0, to = 0;
};
/// The differences of two texts, in order; hunks are never adjacent.
[[nodiscard]] std::vector<LineHunk> lineHunks(std::string_view before, std::string_view after);

/// Three-way merge by lines. Nothing on a conflict: changes of the same or adjacent lines. The same change on both sides counts
/// once.
[[nodiscard]] std::optional<std::string> mergedByLines(std::string_view base, std::string_view mine, std::string_view theirs);

} // namespace trundle
