#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace trundle {

inline constexpr std::string_view kBom = "\xEF\xBB\xBF";
inline constexpr std::string_view kUnicodeMinus = "\xE2\x88\x92";

/// One code point at `at`; a byte that starts no valid sequence is one invalid byte.
struct CodePoint {
    std::uint32_t value = 0;
    std::uint32_t length = 1;
    bool valid = false;
};

/// Strict decoding: no overlong forms, no surrogates, nothing above U+10FFFF. `at` must be inside `text`.
[[nodiscard]] inline CodePoint codePointAt(std::string_view text, std::size_t at) {
    const auto byte = [&](std::size_t i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(text[i])); };
    const std::uint32_t first = byte(at);
    if (first < 0x80) return {first, 1, true};
    const std::uint32_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() - at < length) return {first, 1, false};
    std::uint32_t value = first & (0x7Fu >> length);
    for (std::uint32_t i = 1; i < length; ++i) {
        if ((byte(at + i) & 0xC0) != 0x80) return {first, 1, false};
        value = value << 6 | (byte(at + i) & 0x3F);
    }
    constexpr std::uint32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
    if (value < smallest[length] || (value >= 0xD800 && value < 0xE000) || value > 0x10FFFF) return {first, 1, false};
    return {value, length, true};
}

} // namespace trundle
