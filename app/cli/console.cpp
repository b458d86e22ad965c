#include "cli/console.h"

#include <trundle/abi.h>

#include "base/clean_text.h"
#include "cli/numbers.h"

namespace trundle {

std::string consoleLines(double time, std::string_view who, int severity, std::string_view text) {
    std::string prefix = "[" + exactText(time);
    if (!who.empty()) prefix += " " + cleanLine(who);
    prefix += "] ";
    if (severity == TRUNDLE_WARNING) prefix += "warning: ";
    if (severity == TRUNDLE_ERROR) prefix += "error: ";

    if (text.ends_with('\n')) text.remove_suffix(1);
    std::string lines;
    for (;;) {
        const std::size_t end = text.find('\n');
        lines += prefix + cleanLine(text.substr(0, end)) + "\n";
        if (end == std::string_view::npos) return lines;
        text.remove_prefix(end + 1);
    }
}

} // namespace trundle
