#include "meshreader/picture_options.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

namespace trundle {
namespace {

constexpr std::string_view kBlanks = " \t";
constexpr std::size_t kMaxNameBytes = 1000; // assimp silently drops longer names, so the missing picture would not be reported

std::string_view trimmed(std::string_view text) {
    const std::size_t from = text.find_first_not_of(kBlanks);
    return from == std::string_view::npos ? std::string_view() : text.substr(from, text.find_last_not_of(kBlanks) - from + 1);
}

/// Removes and returns the first word of a trimmed text.
std::string_view parseWord(std::string_view& text) {
    const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
    text = trimmed(text.substr(word.size()));
    return word;
}

std::string lower(std::string_view word) {
    std::string result(word);
    for (char& letter : result)
        if (letter >= 'A' && letter <= 'Z') letter = static_cast<char>(letter - 'A' + 'a');
    return result;
}

std::optional<float> numberIn(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float number = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), number);
    if (fault != std::errc{} || end != word.data() + word.size() || !std::isfinite(number)) return std::nullopt;
    return number;
}

bool hasOneArgument(const std::string& option) {
    static constexpr std::string_view known[] = {"-blendu", "-blendv",  "-bm",     "-boost", "-cc",
                                                 "-clamp",  "-imfchan", "-texres", "-type"};
    return std::find(std::begin(known), std::end(known), option) != std::end(known);
}

/// Removes and parses the options; the last word is always the picture's name.
TextureTransform parseOptions(std::string_view& text) {
    TextureTransform placement;
    while (text.starts_with('-')) {
        std::string_view rest = text;
        const std::string option = lower(parseWord(rest));
        if (rest.empty()) break;
        text = rest;
        const bool oneWord = hasOneArgument(option);
        const std::size_t most = oneWord ? 1 : option == "-mm" ? 2 : 3;
        for (std::size_t i = 0; i < most; ++i) {
            const std::optional<float> number = numberIn(parseWord(rest));
            if (rest.empty() || (!number && !oneWord)) break;
            text = rest;
            if (i < 2 && option == "-s") placement.scale[i] = *number;
            if (i < 2 && option == "-o") placement.offset[i] = *number;
        }
    }
    return placement;
}

} // namespace

std::string withoutPictureOptions(std::string_view materials, std::map<std::string, TextureTransform>& placements) {
    std::string result, material;
    while (!materials.empty()) {
        const std::string_view line = materials.substr(0, materials.find_first_of("\r\n"));
        std::string_view rest = trimmed(line);
        const std::string key = lower(parseWord(rest));
        if (key == "newmtl") material = rest;
        if (key == "map_kd") {
            placements[material] = parseOptions(rest);
            (result += "map_Kd ") += rest.substr(0, kMaxNameBytes);
        } else result += line;
        materials.remove_prefix(line.size());
        const std::size_t ends = std::min(materials.find_first_not_of("\r\n"), materials.size());
        result += materials.substr(0, ends);
        materials.remove_prefix(ends);
    }
    return result;
}

} // namespace trundle
