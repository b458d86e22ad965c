#include "meshreader/deep_pgm.h"

#include <algorithm>
#include <charconv>

namespace trundle {
namespace {

constexpr std::string_view kSpace = " \t\n\v\f\r";

/// Takes the next whole number, after space and comments, from the front of the text.
std::optional<std::uint32_t> nextNumber(std::string_view& text) {
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(kSpace), text.size()));
        if (!text.starts_with('#')) break;
        text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    }
    std::uint32_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc()) return std::nullopt;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return number;
}

} // namespace

std::optional<DeepPgm> deepPgmIn(std::string_view content) {
    if (!content.starts_with("P5") && !content.starts_with("P2")) return std::nullopt;
    DeepPgm picture;
    picture.isText = content[1] == '2';
    content.remove_prefix(2);
    const auto columns = nextNumber(content), rows = nextNumber(content), most = nextNumber(content);
    if (!columns || !rows || !most || *most < 256 || *most > 65535 || content.empty()) return std::nullopt;
    picture.columns = *columns;
    picture.rows = *rows;
    picture.most = *most;
    picture.points = content.substr(1); // after one space
    return picture;
}

std::optional<std::vector<float>> DeepPgm::heights() const {
    std::string_view left = points;
    const std::size_t count = std::size_t{columns} * rows;
    if (left.size() < 2 * count - (isText ? 1 : 0)) return std::nullopt; // a digit and a space each
    std::vector<float> heights;
    heights.reserve(count);
    while (heights.size() < count) {
        std::optional<std::uint32_t> value;
        if (isText) value = nextNumber(left);
        else {
            value = static_cast<unsigned char>(left[0]) << 8 | static_cast<unsigned char>(left[1]);
            left.remove_prefix(2);
        }
        if (!value || *value > most) return std::nullopt;
        heights.push_back(static_cast<float>(*value / static_cast<double>(most)));
    }
    return heights;
}

} // namespace trundle
