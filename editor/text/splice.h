#pragma once
// Two versions of a text, and the least that has to change to make one of the other.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// `removed` bytes at `at` become `text`.
struct Splice {
    std::size_t at = 0, removed = 0;
    std::string text;
    bool operator==(const Splice&) const = default;
};

/// What makes `to` of `from`, in order, with places as in `from`; empty where they are equal. No splice cuts a character or a
/// CR LF in two. Where as many lines stand between the first and the last difference, lines that are equal stay untouched.
[[nodiscard]] std::vector<Splice> splicesBetween(std::string_view from, std::string_view to);

/// The text with the splices carried out.
[[nodiscard]] std::string spliced(std::string_view text, const std::vector<Splice>& splices);

/// Where an offset of the old text is in the new one; inside what is removed: its end there.
[[nodiscard]] std::size_t movedOffset(std::size_t offset, const std::vector<Splice>& splices);

/// Both changes of `base` in one text. Where they touch the same bytes, `theirs` stands and what `ours` wrote follows it.
[[nodiscard]] std::string merged(std::string_view base, std::string_view ours, std::string_view theirs);

} // namespace trundle
