#include "lang/parsing/syntax_reporter.h"

#include <algorithm>

namespace trundle {

Diagnostic& SyntaxReporter::report(Severity severity, Code code, TextRange r, std::string message) {
    if (isFull() || r.begin >= m_cut) return m_unreported = {};
    if (m_diagnostics.size() == kMaxDiagnostics) {
        code = Code::TooManyMistakes;
        message = "too many mistakes, the rest of this file is not reported";
        severity = Severity::Error;
    }
    Diagnostic& d = m_diagnostics.emplace_back();
    d.severity = severity;
    d.code = code;
    d.message = std::move(message);
    d.range = {m_file, r};
    return d;
}

void SyntaxReporter::semicolon(TextRange r) {
    constexpr std::size_t kMaxEdits = 10'000; // bounds the size of the fix
    if (m_semicolon == 0) {
        Diagnostic& d = error(Code::UnexpectedText, r, "no `;` is needed");
        d.fixes.push_back({"remove `;`", {}});
        m_semicolon = indexOf(d);
        if (m_semicolon == 0) return;
    }
    Fix& fix = at(m_semicolon).fixes.back();
    if (fix.edits.size() == kMaxEdits) return;
    if (fix.edits.size() == 1) fix.title = "remove each `;`";
    fix.edits.push_back({{m_file, r}, ""});
}

Diagnostic* SyntaxReporter::lastAt(TextRange r) {
    return !m_diagnostics.empty() && m_diagnostics.back().range.range == r ? &m_diagnostics.back() : nullptr;
}

std::size_t SyntaxReporter::indexOf(const Diagnostic& d) const {
    return !m_diagnostics.empty() && &d == &m_diagnostics.back() ? m_diagnostics.size() : 0;
}

std::vector<Diagnostic> SyntaxReporter::takeSorted() {
    std::stable_sort(m_diagnostics.begin(), m_diagnostics.end(),
                     [](const Diagnostic& a, const Diagnostic& b) { return a.range.range.begin < b.range.range.begin; });
    return std::move(m_diagnostics);
}

} // namespace trundle
