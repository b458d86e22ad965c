// Recovery from unbalanced braces: which block is open, and where, according to the indentation, its `}` is missing.

#include <algorithm>

#include "lang/characters.h"
#include "lang/parser.h"

namespace trundle {

int Parser::indentOf(std::uint32_t offset) const {
    constexpr int kTab = 4;
    const std::string_view bytes = m_source->bytes();
    int columns = 0;
    while (offset > 0 && isBlank(bytes[offset - 1])) {
        columns += bytes[offset - 1] == '\t' ? kTab : 1;
        --offset;
    }
    return offset == 0 || bytes[offset - 1] == '\n' || bytes[offset - 1] == '\r' ? columns : -1;
}

/// Records a suspected missing `}` if the token that begins an item or closes the block is indented less than the block's items.
void Parser::recordIndent() {
    OpenBlock& open = m_open.back();
    if (!newLine() && m_at == open.openAt + 1 && kind() != TokenKind::CloseBrace) open.inlineItems = true;
    if (open.indent < 0 || !newLine()) return;
    const int indent = indentOf(range().begin);
    if (indent < 0) return;
    const bool closes = kind() == TokenKind::CloseBrace;
    if (indent > open.indent) open.indentedItems = open.indentedItems || !closes;
    else if (closes ? indent < open.indent : open.indentedItems)
        m_suspects.push_back({open.openAt, static_cast<std::uint32_t>(m_at)});
    else if (!closes && open.inlineItems && namedBlock()) m_onOneLine.push_back({open.openAt, static_cast<std::uint32_t>(m_at)});
}

/// The positions where a `}` may be missing, most likely first.
std::vector<Parser::MissingBrace> Parser::likelyMissing() const {
    const auto earlier = [](const MissingBrace& a, const MissingBrace& b) { return a.before < b.before; };
    std::vector<MissingBrace> places;
    if (!m_suspects.empty()) places.push_back(*std::min_element(m_suspects.begin(), m_suspects.end(), earlier));
    std::vector<MissingBrace> lines = m_onOneLine;
    if (!places.empty()) std::erase_if(lines, [&](const MissingBrace& m) { return m.openAt != places[0].openAt; });
    if (!lines.empty()) places.insert(places.begin(), *std::min_element(lines.begin(), lines.end(), earlier));
    return places;
}

/// True at `]` or `)` if the block was also opened with a bracket.
bool Parser::foreignClose() const {
    return m_open.back().bracket && (kind() == TokenKind::CloseParen || (kind() == TokenKind::Unknown && text() == "]"));
}

/// Records a possibly premature `}`: an item after the block that starts a line and is indented deeper than the block may still
/// belong to it.
void Parser::recordEarlyClose(int indent, std::size_t brace) {
    if (indent < 0 || !newLine() || atEnd() || kind() == TokenKind::CloseBrace) return;
    if (indentOf(range().begin) > indent) m_early.push_back(static_cast<std::uint32_t>(brace));
}

bool Parser::ignoredBrace() const { return std::find(m_ignored.begin(), m_ignored.end(), m_at) != m_ignored.end(); }

/// If braces do not balance and the indentation shows which one is missing or superfluous, parses again with that correction, so
/// that one brace causes one diagnostic. False if there is no such position or the result is worse.
bool Parser::assume() {
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

bool Parser::closedHere(const OpenBlock& block) const {
    return std::any_of(m_assumed.begin(), m_assumed.end(),
                       [&](const MissingBrace& m) { return m.openAt == block.openAt && m.before == m_at; });
}

void Parser::reportUnclosed(const OpenBlock& open, std::uint32_t place) {
    if (atEnd() && m_tree->m_extent != Tree::Extent::Whole) return; // parsing stopped before its end
    const std::string_view bytes = m_source->bytes();
    if (atEnd()) m_unclosed = true;
    Diagnostic& d = error(Code::UnclosedBlock, open.name, "block `" + std::string(slice(open.name)) + "` lacks its closing `}`");
    const std::string indent(static_cast<std::size_t>(std::max(open.indent, 0)), ' ');
    const std::uint32_t last = previous().end;
    if (!atEnd() && open.inlineItems && slice({open.name.begin, last}).find_first_of("\r\n") == std::string_view::npos) {
        fix(d, "insert `}` at the end of line " + std::to_string(m_source->position(last).line), {edit({last, last}, " }")});
        return;
    }
    if (!atEnd()) {
        // Insert at the start of the line of the token that no longer belongs to the block.
        std::uint32_t line = place;
        while (line > 0 && isBlank(bytes[line - 1])) --line;
        d.notes.push_back({"the indentation suggests it before this line", {m_file, range()}});
        fix(d, "insert `}` before line " + std::to_string(m_source->position(place).line),
            {edit({line, line}, indent + "}" + lineEnd())});
        return;
    }
    const bool ownLine = bytes.empty() || bytes.back() == '\n' || bytes.back() == '\r';
    fix(d, "insert `}` at the end", {edit({place, place}, (ownLine ? "" : lineEnd()) + indent + "}" + lineEnd())});
}

} // namespace trundle
