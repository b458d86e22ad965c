#include "cli/console.h"

#include <trundle/abi.h>

#include "cli/numbers.h"

namespace trundle {

std::string safeText(std::string_view text) {
    std::string safe;
    safe.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0u;
        if (c == 0xc2 && next >= 0x80 && next < 0xa0) { // the other control characters, in UTF-8
            safe += '?';
            ++i;
        } else {
            safe += (c < 0x20 && c != '\t') || c == 0x7f ? '?' : text[i];
        }
    }
    return safe;
}

std::string consoleLines(double time, std::string_view who, int severity, std::string_view text) {
    std::string prefix = "[" + exactText(time);
    if (!who.empty()) prefix += " " + safeText(who);
    prefix += "] ";
    if (severity == TRUNDLE_WARNING) prefix += "warning: ";
    if (severity == TRUNDLE_ERROR) prefix += "error: ";

    if (text.ends_with('\n')) text.remove_suffix(1);
    std::string lines;
    for (;;) {
        const std::size_t end = text.find('\n');
        lines += prefix + safeText(text.substr(0, end)) + "\n";
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

} // namespace trundle
