#pragma once
// Collects the diagnostics of one parse, at most a hundred. Private to core/lang.

#include <limits>
#include <map>
#include <string>
#include <utility>
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
    void semicolon(TextRange r) { needless(m_semicolon, r, "no `;` is needed", Code::UnexpectedText, {}); }
    /// A `,` behind a value or block: one message for all of them likewise. `alone` is said if there is but one.
    void comma(TextRange r, std::string alone, Code code);
    /// A `:`, `:=` or `==` between a key and its value: one message for each of these, with a fix for all of them. `joined`: it touches
    /// the key.
    void wrongEquals(TextRange r, std::string_view sign, bool joined);
    /// A comma between two items of a line, where no element is missing. `between`: what takes its place.
    void separator(TextRange r, std::string between);
    /// From now on such commas are part of this diagnostic, of which its last fix removes them, too; 0: of none. Returns the one
    /// before.
    std::size_t joinSeparators(std::size_t fault) { return std::exchange(m_separatorFault, fault); }
    /// Reports that a text has blocks by indentation, once.
    void indentation(TextRange r, std::string message);
    /// If one more diagnostic follows this one and has this code, it becomes part of it: its message and its last fix, whose title
    /// gets `title` in front.
    void mergeNext(std::size_t fault, Code code, std::string_view title);
    /// Nothing is reported until it is set to false.
    void setSilent(bool silent) { m_silent = silent; }
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
        m_semicolon = m_comma = m_separatorFault = 0;
        m_wrongEquals.clear();
        m_hasIndentation = false;
        m_silent = false;
    }
    [[nodiscard]] std::vector<Diagnostic> takeSorted(); ///< in the order of their positions

private:
    void needless(std::size_t& index, TextRange r, std::string message, Code code, std::string between);

    static constexpr const char* kNoComma = "no `,` is needed behind a property or a block";
    static constexpr std::size_t kMaxDiagnostics = 100; ///< bounds the number of messages for an unreadable text

    FileId m_file;
    std::uint32_t m_cut = std::numeric_limits<std::uint32_t>::max();
    std::vector<Diagnostic> m_diagnostics;
    std::size_t m_semicolon = 0; ///< 1-based index of the message about `;`
    std::size_t m_comma = 0;     ///< likewise about a `,` that is too much
    std::map<std::string, std::size_t, std::less<>> m_wrongEquals; ///< likewise about each sign in place of `=`
    std::size_t m_separatorFault = 0;                              ///< likewise, of what commas between items belong to
    bool m_hasIndentation = false;                                 ///< is reported
    bool m_silent = false;
    Diagnostic m_unreported; ///< receives diagnostics beyond the limit
};

} // namespace trundle
