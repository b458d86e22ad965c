#include "base/clean_text.h"

#include "base/utf8.h"

namespace trundle {
namespace {

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

std::string clean(std::string_view text, char lineBreak) {
    std::string safe;
    safe.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const CodePoint point = codePointAt(text, at);
        const std::string_view bytes = text.substr(at, point.length);
        at += point.length;
        if (point.valid && (point.value == '\n' || point.value == '\r')) {
            if (point.value == '\n' || at >= text.size() || text[at] != '\n') safe += lineBreak;
        } else {
            safe += point.valid && (point.value == '\t' || !isControl(point.value)) ? bytes : kReplacement;
        }
    }
    return safe;
}

} // namespace

namespace {

/// Zero width: two names that look the same would differ. The joiners of scripts and emoji are not among them.
bool isInvisible(std::uint32_t codePoint) {
    return codePoint == 0x200B || (codePoint >= 0x2060 && codePoint <= 0x2064) || codePoint == 0xFEFF ||
           (codePoint >= 0xFFF9 && codePoint <= 0xFFFB) || (codePoint >= 0xE0000 && codePoint <= 0xE007F);
}

} // namespace

bool isControl(std::uint32_t codePoint) {
    return isInvisible(codePoint) || codePoint < 0x20 || (codePoint >= 0x7F && codePoint < 0xA0) || codePoint == 0x061C ||
           codePoint == 0x200E || codePoint == 0x200F || (codePoint >= 0x2028 && codePoint <= 0x202E) ||
           (codePoint >= 0x2066 && codePoint <= 0x2069);
}

std::string cleanText(std::string_view text) { return clean(text, '\n'); }

std::string cleanLine(std::string_view text) { return clean(text, ' '); }

} // namespace trundle
