#pragma once
// The difference of two texts as one replaced range: undo steps and journals store this instead of whole files.

#include <cstdint>
#include <string>
#include <string_view>

namespace trundle {

/// At byte `at`, `removed` is replaced by `inserted`.
struct TextSplice {
    std::uint64_t at = 0;
    std::string removed, inserted;

    [[nodiscard]] bool empty() const { return removed.empty() && inserted.empty(); }
};

/// The shortest splice from one text to the other.
[[nodiscard]] TextSplice spliceBetween(std::string_view before, std::string_view after);
/// Applies a splice; exact if `before` is the text that it was made from.
[[nodiscard]] std::string spliced(std::string_view before, const TextSplice& splice);
/// Reverts a splice.
[[nodiscard]] std::string unspliced(std::string_view after, const TextSplice& splice);
/// One splice with the effect of two in sequence; `middle` is the text after the first and before the second.
[[nodiscard]] TextSplice joined(const TextSplice& first, const TextSplice& second, std::string_view middle);

} // namespace trundle
