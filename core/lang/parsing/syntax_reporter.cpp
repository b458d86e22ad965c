#include "lang/parsing/syntax_reporter.h"

#include <algorithm>

namespace trundle {

Diagnostic& SyntaxReporter::report(Severity severity, Code code, TextRange r, std::string message) {
    if (m_silent || isFull() || r.begin >= m_cut) return m_unreported = {};
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

void SyntaxReporter::needless(std::size_t& index, TextRange r, std::string message, Code code) {
    constexpr std::size_t kMaxEdits = 10'000; // bounds the size of the fix
    if (m_silent) return;
    if (index == 0) {
        Diagnostic& d = error(code, r, std::move(message));
        d.fixes.push_back({"remove `" + std::string(&index == &m_comma ? "," : ";") + "`", {}});
        index = indexOf(d);
        if (index == 0) return;
    }
    Fix& fix = at(index).fixes.back();
    if (fix.edits.size() == kMaxEdits) return;
    if (fix.edits.size() == 1) fix.title = "remove each `" + std::string(&index == &m_comma ? "," : ";") + "`";
    fix.edits.push_back({{m_file, r}, ""});
}

void SyntaxReporter::comma(TextRange r, std::string alone, Code code) {
    const bool first = m_comma == 0;
    needless(m_comma, r, std::move(alone), code);
    if (first || m_comma == 0) return;
    at(m_comma).message = kNoComma;
    at(m_comma).code = Code::UnexpectedText;
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
