#include "lang/parsing/brace_balance.h"

#include <algorithm>

#include "lang/characters.h"

namespace trundle {

void BraceBalance::beginRun() {
    m_open.clear();
    m_suspects.clear();
    m_onOneLine.clear();
    m_early.clear();
    m_unmatchedBraces = 0;
    m_unclosed = false;
}

int BraceBalance::indentOf(std::uint32_t offset) const {
    constexpr int kTab = 4;
    const std::string_view bytes = this->bytes();
    int columns = 0;
    while (offset > 0 && isBlank(bytes[offset - 1])) {
        columns += bytes[offset - 1] == '\t' ? kTab : 1;
        --offset;
    }
    return offset == 0 || bytes[offset - 1] == '\n' || bytes[offset - 1] == '\r' ? columns : -1;
}

void BraceBalance::recordIndent() {
    OpenBlock& open = m_open.back();
    if (!newLine() && position() == open.openAt + 1 && kind() != TokenKind::CloseBrace) open.inlineItems = true;
    if (open.indent < 0 || !newLine()) return;
    const int indent = indentOf(range().begin);
    if (indent < 0) return;
    const bool closes = kind() == TokenKind::CloseBrace;
    if (indent > open.indent) open.indentedItems = open.indentedItems || !closes;
    else if (closes ? indent < open.indent : open.indentedItems)
        m_suspects.push_back({open.openAt, static_cast<std::uint32_t>(position())});
    else if (!closes && open.inlineItems && namedBlock())
        m_onOneLine.push_back({open.openAt, static_cast<std::uint32_t>(position())});
}

/// The positions where a `}` may be missing, most likely first.
std::vector<BraceBalance::MissingBrace> BraceBalance::likelyMissing() const {
    const auto earlier = [](const MissingBrace& a, const MissingBrace& b) { return a.before < b.before; };
    std::vector<MissingBrace> places;
    if (!m_suspects.empty()) places.push_back(*std::min_element(m_suspects.begin(), m_suspects.end(), earlier));
    std::vector<MissingBrace> lines = m_onOneLine;
    if (!places.empty()) std::erase_if(lines, [&](const MissingBrace& m) { return m.openAt != places[0].openAt; });
    if (!lines.empty()) places.insert(places.begin(), *std::min_element(lines.begin(), lines.end(), earlier));
    return places;
}

bool BraceBalance::foreignClose() const {
    return m_open.back().bracket && (kind() == TokenKind::CloseParen || (kind() == TokenKind::Unknown && text() == "]"));
}

void BraceBalance::recordEarlyClose(int indent, std::size_t brace) {
    if (indent < 0 || !newLine() || atEnd() || kind() == TokenKind::CloseBrace) return;
    if (indentOf(range().begin) > indent) m_early.push_back(static_cast<std::uint32_t>(brace));
}

bool BraceBalance::isIgnored() const { return std::find(m_ignored.begin(), m_ignored.end(), position()) != m_ignored.end(); }

bool BraceBalance::assume(const std::function<void()>& run) {
    const bool wasUnclosed = m_unclosed;
    const int strays = m_unmatchedBraces;
    if (const std::vector<MissingBrace> places = likelyMissing(); m_unclosed && !places.empty()) {
        for (const MissingBrace& place : places) {
            m_assumed.push_back(place);
            run();
            if (m_unmatchedBraces <= strays) return true;
            m_assumed.pop_back();
        }
    } else if (m_unmatchedBraces > 0 && !m_early.empty()) {
        m_ignored.push_back(m_early.front());
        run();
        if (m_unmatchedBraces < strays && m_unclosed == wasUnclosed) return true;
        m_ignored.pop_back();
    } else {
        return false;
    }
    run();
    return false;
}

bool BraceBalance::closedHere(const OpenBlock& block) const {
    return std::any_of(m_assumed.begin(), m_assumed.end(),
                       [&](const MissingBrace& m) { return m.openAt == block.openAt && m.before == position(); });
}

void BraceBalance::reportUnclosed(const OpenBlock& open, std::uint32_t place) {
    if (atEnd() && m_tokens.extent() != Tree::Extent::Whole) return; // parsing stopped before its end
    const std::string_view bytes = this->bytes();
    if (atEnd()) m_unclosed = true;
    Diagnostic& d = error(Code::UnclosedBlock, open.name, "block `" + std::string(slice(open.name)) + "` lacks its closing `}`");
    const std::string indent(static_cast<std::size_t>(std::max(open.indent, 0)), ' ');
    const std::uint32_t last = previous().end;
    if (!atEnd() && open.inlineItems && slice({open.name.begin, last}).find_first_of("\r\n") == std::string_view::npos) {
        fix(d, "insert `}` at the end of line " + std::to_string(m_tokens.source().position(last).line),
            {edit({last, last}, " }")});
        return;
    }
    if (!atEnd()) {
        // Insert at the start of the line of the token that no longer belongs to the block.
        std::uint32_t line = place;
        while (line > 0 && isBlank(bytes[line - 1])) --line;
        d.notes.push_back({"the indentation suggests it before this line", {m_report.file(), range()}});
        fix(d, "insert `}` before line " + std::to_string(m_tokens.source().position(place).line),
            {edit({line, line}, indent + "}" + m_tokens.lineEnd())});
        return;
    }
    const bool ownLine = bytes.empty() || bytes.back() == '\n' || bytes.back() == '\r';
    fix(d, "insert `}` at the end",
        {edit({place, place}, (ownLine ? "" : m_tokens.lineEnd()) + indent + "}" + m_tokens.lineEnd())});
}

} // namespace trundle
