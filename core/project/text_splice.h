#pragma once
// The difference of two texts as one replaced stretch: what an undo step and a journal keep instead of whole files.

#include <cstdint>
#include <string>
#include <string_view>

namespace trundle {

/// At byte `at`, `removed` stood before and `inserted` stands after.
struct TextSplice {
    std::uint64_t at = 0;
    std::string removed, inserted;

    [[nodiscard]] bool empty() const { return removed.empty() && inserted.empty(); }
};

/// The shortest one that leads from one text to the other.
[[nodiscard]] TextSplice spliceBetween(std::string_view before, std::string_view after);
/// The text after; exact where `before` is the text that the splice was made from.
[[nodiscard]] std::string spliced(std::string_view before, const TextSplice& splice);
/// The text before.
[[nodiscard]] std::string unspliced(std::string_view after, const TextSplice& splice);

} // namespace trundle
