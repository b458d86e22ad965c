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

namespace {

constexpr std::size_t kMaxEdits = 10'000; ///< bounds the size of a fix

} // namespace

void SyntaxReporter::needless(std::size_t& index, TextRange r, std::string message, Code code, std::string between) {
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
    fix.edits.push_back({{m_file, r}, std::move(between)});
}

void SyntaxReporter::wrongEquals(TextRange r, std::string_view sign, bool joined) {
    const TextEdit edit{{m_file, r}, sign == ":" && joined ? " =" : "="};
    const auto index = m_wrongEquals.try_emplace(std::string(sign), 0).first;
    if (m_silent) return;
    if (index->second == 0) {
        Diagnostic& d = error(Code::UnexpectedText, r, "`=` expected, not `" + std::string(sign) + "`");
        d.fixes.push_back({"=", {edit}});
        index->second = indexOf(d);
    } else if (Fix& fix = at(index->second).fixes.back(); fix.edits.size() < kMaxEdits) {
        fix.title = "= in place of each `" + std::string(sign) + "`";
        fix.edits.push_back(edit);
    }
}

void SyntaxReporter::separator(TextRange r, std::string between) {
    if (m_separatorFault == 0) return needless(m_comma, r, kNoComma, Code::UnexpectedText, std::move(between));
    if (m_silent) return;
    Fix& fix = at(m_separatorFault).fixes.back();
    if (fix.edits.size() < kMaxEdits) fix.edits.push_back({{m_file, r}, std::move(between)});
}

void SyntaxReporter::indentation(TextRange r, std::string message) {
    if (std::exchange(m_hasIndentation, true)) return;
    error(Code::UnexpectedText, r, std::move(message));
}

void SyntaxReporter::mergeNext(std::size_t fault, Code code, std::string_view title) {
    if (fault == 0 || m_diagnostics.size() != fault + 1 || m_diagnostics.back().code != code) return;
    Diagnostic next = std::move(m_diagnostics.back());
    m_diagnostics.pop_back();
    Diagnostic& all = m_diagnostics.back();
    all.message += ", and " + next.message;
    if (all.fixes.empty() || next.fixes.empty()) return;
    Fix& last = next.fixes.back();
    all.fixes.back().title = std::string(title) + last.title;
    for (TextEdit& edit : last.edits) all.fixes.back().edits.push_back(std::move(edit));
}

void SyntaxReporter::comma(TextRange r, std::string alone, Code code) {
    const bool first = m_comma == 0;
    needless(m_comma, r, std::move(alone), code, {});
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
