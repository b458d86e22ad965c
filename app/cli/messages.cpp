#include "cli/messages.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>

#include <unistd.h>

#include "base/clean_text.h"
#include "cli/numbers.h"
#include "cli/run_guard.h"
#include "cli/standard_streams.h"
#include "lang/diagnostic_text.h"

namespace trundle {

namespace {

constexpr std::size_t kMaxShown = 100;

} // namespace

void printDiagnostics(const std::vector<Diagnostic>& diagnostics, const SourceTable& sources) {
    // Limits the number of messages; errors take precedence.
    std::size_t errorsLeft = kMaxShown;
    const auto errors = static_cast<std::size_t>(std::ranges::count(diagnostics, Severity::Error, &Diagnostic::severity));
    std::size_t othersLeft = kMaxShown - std::min(errors, kMaxShown);
    std::uint64_t hidden = 0;
    for (const Diagnostic& diagnostic : diagnostics) {
        if (diagnostic.more > 0 && hidden + errors > kMaxShown) {
            hidden += diagnostic.more;
            continue;
        }
        std::size_t& left = diagnostic.severity == Severity::Error ? errorsLeft : othersLeft;
        if (left == 0) {
            ++hidden;
            continue;
        }
        --left;
        std::string text = render(diagnostic, sources);
        if (!text.ends_with('\n')) text += '\n';
        writeMessage(text);
    }
    if (hidden) writeMessage("... and " + counted(hidden, "more message") + "\n");
}

void printProblem(const std::string& text) { writeMessage("trundle-cli: " + cleanLine(text) + "\n"); }

std::string countText(const std::vector<Diagnostic>& diagnostics) {
    const auto count = [&](Severity severity) {
        std::uint64_t count = 0;
        for (const Diagnostic& d : diagnostics)
            if (d.severity == severity) count += d.more > 0 ? d.more : 1;
        return count;
    };
    const std::uint64_t errors = count(Severity::Error), warnings = count(Severity::Warning);
    std::string text;
    if (errors) text = counted(errors, "error");
    if (warnings) text += (text.empty() ? "" : ", ") + counted(warnings, "warning");
    return text;
}

bool writeOut(const std::string& bytes) {
    if (isForkedCopy()) endForkedCopy(); // the original writes them
    std::string_view rest = bytes;
    while (!rest.empty()) {
        const ssize_t done = ::write(resultsFile(), rest.data(), rest.size());
        if (done < 0 && errno == EINTR) continue;
        if (done < 0) {
            printProblem(std::string("cannot write to standard output: ") + std::strerror(errno));
            return false;
        }
        rest.remove_prefix(static_cast<std::size_t>(done));
    }
    return true;
}

} // namespace trundle
