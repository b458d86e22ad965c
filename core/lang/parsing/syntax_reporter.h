#pragma once
// Collects the diagnostics of one parse, at most a hundred. Private to core/lang.

#include <limits>
#include <string>
#include <vector>

#include "base/diagnostic.h"

namespace trundle {

class SyntaxReporter {
public:
    explicit SyntaxReporter(FileId file) : m_file(file) {}

    /// The caller may fill in the returned diagnostic until the next call.
    Diagnostic& report(Severity severity, Code code, TextRange r, std::string message);
    Diagnostic& error(Code code, TextRange r, std::string message) {
        return report(Severity::Error, code, r, std::move(message));
    }
    /// A `;`: one message for all of them, with a fix that removes them.
    void semicolon(TextRange r);
    /// Errors from this offset on may only be caused by parsing having stopped there: they are not reported.
    void setCut(std::uint32_t offset) { m_cut = offset; }
    void changeLast(std::string message) { m_diagnostics.back().message = std::move(message); }

    [[nodiscard]] bool isFull() const { return m_diagnostics.size() > kMaxDiagnostics; }
    [[nodiscard]] std::size_t count() const { return m_diagnostics.size(); }
    [[nodiscard]] Diagnostic* lastAt(TextRange r); ///< the last diagnostic if its range is `r`
    /// 1-based index of a diagnostic just reported; 0 if it was left out.
    [[nodiscard]] std::size_t indexOf(const Diagnostic& d) const;
    [[nodiscard]] Diagnostic& at(std::size_t index) { return m_diagnostics[index - 1]; } ///< 1-based
    [[nodiscard]] FileId file() const { return m_file; }

    void clear() {
        m_diagnostics.clear();
        m_semicolon = 0;
    }
    [[nodiscard]] std::vector<Diagnostic> takeSorted(); ///< in the order of their positions

private:
    static constexpr std::size_t kMaxDiagnostics = 100; ///< bounds the number of messages for an unreadable text

    FileId m_file;
    std::uint32_t m_cut = std::numeric_limits<std::uint32_t>::max();
    std::vector<Diagnostic> m_diagnostics;
    std::size_t m_semicolon = 0; ///< 1-based index of the message about `;`
    Diagnostic m_unreported; ///< receives diagnostics beyond the limit
};

} // namespace trundle
