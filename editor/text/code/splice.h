#pragma once
// Differences between two versions of a text as a list of splices.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace trundle {

/// Replaces the `removed` bytes at `at` by `text`.
struct Splice {
    std::size_t at = 0, removed = 0;
    std::string text;
    bool operator==(const Splice&) const = default;
};

/// The splices from `from` to `to`, in order, with offsets in `from`; empty if the texts are equal. No splice divides a
/// character or a CR LF. If the range of changes has as many lines in both texts, its unchanged lines get no splice.
[[nodiscard]] std::vector<Splice> splicesBetween(std::string_view from, std::string_view to);

/// The text with the splices applied.
[[nodiscard]] std::string spliced(std::string_view text, const std::vector<Splice>& splices);

/// Maps an offset of the old text to the new one; an offset inside a removed range maps to the end of its replacement.
[[nodiscard]] std::size_t movedOffset(std::size_t offset, const std::vector<Splice>& splices);

/// Applies both changes of `base`. Where they overlap, `theirs` is kept and the text inserted by `ours` follows it.
[[nodiscard]] std::string merged(std::string_view base, std::string_view ours, std::string_view theirs);

} // namespace trundle
