#pragma once
// What we tell a user about a text: severity, code, words, place and, where it is obvious, the edit that mends it.

#include <string>
#include <utility>
#include <vector>

#include "base/codes.h"
#include "base/source_range.h"
#include "base/text_edit.h"

namespace trundle {

enum class Severity { Error, Warning, Hint };

/// A titled set of edits, applied together.
struct Fix {
    std::string title; ///< the replacement itself where it is short: "3cm"
    std::vector<TextEdit> edits;
};

struct Diagnostic {
    Severity severity = Severity::Error;
    Code code = Code::Internal;
    std::string message; ///< one line, no full stop, no code, no place
    SourceRange range;
    std::vector<std::string> suggestions; ///< replacement words, best first
    std::vector<Fix> fixes;
    std::vector<std::pair<std::string, SourceRange>> notes; ///< "first defined here"
};

/// Collects diagnostics; passed down every stage of text → model.
class Diagnostics {
public:
    Diagnostic& add(Severity severity, Code code, SourceRange range, std::string message);
    Diagnostic& error(Code code, SourceRange range, std::string message) {
        return add(Severity::Error, code, range, std::move(message));
    }
    Diagnostic& warning(Code code, SourceRange range, std::string message) {
        return add(Severity::Warning, code, range, std::move(message));
    }
    Diagnostic& hint(Code code, SourceRange range, std::string message) {
        return add(Severity::Hint, code, range, std::move(message));
    }
    void append(std::vector<Diagnostic> more);

    [[nodiscard]] const std::vector<Diagnostic>& all() const { return m_all; }
    [[nodiscard]] bool hasErrors() const { return m_errors > 0; }
    [[nodiscard]] std::size_t errorCount() const { return m_errors; }

private:
    std::vector<Diagnostic> m_all; // a reference from add() is good until the next add()
    std::size_t m_errors = 0;
};

} // namespace trundle
