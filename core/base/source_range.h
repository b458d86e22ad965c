#pragma once
#include <compare>
#include <cstdint>

namespace trundle {

/// Bytes [begin, end) of one text.
struct TextRange {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;

    [[nodiscard]] std::uint32_t size() const { return end - begin; }
    [[nodiscard]] bool contains(std::uint32_t offset) const { return begin <= offset && offset < end; }
    auto operator<=>(const TextRange&) const = default;
};

/// Index of a text in its SourceTable; kNoFile means no position in any text (for example a default value).
using FileId = std::uint32_t;
inline constexpr FileId kNoFile = 0xffffffffu;

/// A range of bytes in a text of a SourceTable.
struct SourceRange {
    FileId file = kNoFile;
    TextRange range;

    [[nodiscard]] bool known() const { return file != kNoFile; }
    auto operator<=>(const SourceRange&) const = default;
};

} // namespace trundle
