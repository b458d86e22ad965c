#include "lang/parsing/brace_balance.h"

#include <algorithm>

#include "lang/characters.h"

namespace trundle {

void BraceBalance::beginRun() {
    m_open.clear();
    m_suspects.clear();
    m_onOneLine.clear();
    m_early.clear();
    m_noBrace.clear();
    m_unmatchedBraces = m_unclosed = 0;
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
    else if (!closes && open.inlineItems && (open.description || namedBlock()))
        m_onOneLine.push_back({open.openAt, static_cast<std::uint32_t>(position())});
}

void BraceBalance::recordUnmatched() {
    if (m_unmatchedBraces++ == 0) m_firstUnmatched = static_cast<std::uint32_t>(position());
}

/// Where a `}` may be missing, most likely first.
void BraceBalance::addUnclosed(std::vector<Correction>& out) const {
    const auto earlier = [](const MissingBrace& a, const MissingBrace& b) { return a.before < b.before; };
    std::optional<MissingBrace> suspect;
    if (!m_suspects.empty()) suspect = *std::min_element(m_suspects.begin(), m_suspects.end(), earlier);
    std::vector<MissingBrace> lines;
    for (const MissingBrace& m : m_onOneLine) { // the first one of each block
        if (suspect && m.before > suspect->before && m.openAt != suspect->openAt) continue;
        if (std::ranges::none_of(lines, [&](const MissingBrace& other) { return other.openAt == m.openAt; })) lines.push_back(m);
    }
    constexpr std::size_t kMost = 3;
    if (lines.size() > kMost) lines.erase(lines.begin(), lines.end() - kMost);
    for (const MissingBrace& m : lines) out.push_back({m, {}, {}});
    if (suspect) out.push_back({suspect, {}, {}});
}

/// Where a `{` may be missing: the last such words before the first `}` that closes too much.
void BraceBalance::addUnopened(std::vector<Correction>& out) const {
    constexpr std::size_t kMost = 3;
    const std::uint32_t end = m_early.empty() ? m_firstUnmatched : std::min(m_early.front(), m_firstUnmatched);
    for (auto word = m_noBrace.rbegin(); word != m_noBrace.rend() && out.size() < kMost; ++word)
        if (*word < end) out.push_back({{}, {}, *word});
}

std::vector<BraceBalance::Correction> BraceBalance::likely() const {
    std::vector<Correction> all;
    if (m_unclosed > 0) addUnclosed(all);
    if (m_unmatchedBraces == 0) return all;
    addUnopened(all);
    if (!m_early.empty()) all.push_back({{}, m_early.front(), {}});
    return all;
}

bool BraceBalance::foreignClose() const {
    return m_open.back().bracket && (kind() == TokenKind::CloseParen || (kind() == TokenKind::Unknown && text() == "]"));
}

void BraceBalance::recordEarlyClose(int indent, std::size_t brace) {
    if (indent < 0 || !newLine() || atEnd() || kind() == TokenKind::CloseBrace) return;
    if (indentOf(range().begin) > indent) m_early.push_back(static_cast<std::uint32_t>(brace));
}

bool BraceBalance::isIgnored() const { return std::find(m_ignored.begin(), m_ignored.end(), position()) != m_ignored.end(); }

bool BraceBalance::isOpened(std::size_t position) const {
    return std::find(m_opened.begin(), m_opened.end(), position) != m_opened.end();
}

BraceBalance::Fit BraceBalance::fit() const {
    return {m_unmatchedBraces + m_unclosed, m_report.count(), m_suspects.size() + m_onOneLine.size() + m_early.size()};
}

void BraceBalance::apply(const Correction& c, bool take) {
    const auto change = [take](auto& list, const auto& one) {
        if (!one) return;
        if (take) list.push_back(*one);
        else list.pop_back();
    };
    change(m_assumed, c.missing);
    change(m_ignored, c.ignored);
    change(m_opened, c.opened);
}

bool BraceBalance::assume(const std::function<void()>& run) {
    const std::vector<Correction> corrections = likely();
    if (corrections.empty()) return false;
    Fit best = fit();
    const Correction* chosen = nullptr;
    for (const Correction& c : corrections) {
        apply(c, true);
        run();
        if (const Fit now = fit(); now < best) {
            best = now;
            chosen = &c;
        }
        apply(c, false);
    }
    if (chosen) apply(*chosen, true);
    run();
    return chosen != nullptr;
}

bool BraceBalance::closedHere(const OpenBlock& block) const {
    if (block.byIndentation) return kind() == TokenKind::CloseBrace || (newLine() && indentOf(range().begin) <= block.indent);
    return std::any_of(m_assumed.begin(), m_assumed.end(),
                       [&](const MissingBrace& m) { return m.openAt == block.openAt && m.before == position(); });
}

void BraceBalance::reportUnclosed(const OpenBlock& open, std::uint32_t place) {
    if (open.byIndentation || (atEnd() && m_tokens.extent() != Tree::Extent::Whole)) return; // or parsing stopped before its end
    const std::string_view bytes = this->bytes(), before = slice(previous());
    const bool isInString = before.starts_with('"') && !before.ends_with('"') && before.find('}') != std::string_view::npos;
    if (open.description && isInString) return; // which is reported
    if (atEnd()) ++m_unclosed;
    Diagnostic& d = error(Code::UnclosedBlock, open.name, "block `" + std::string(slice(open.name)) + "` lacks its closing `}`");
    const std::string indent(static_cast<std::size_t>(std::max(open.indent, 0)), ' ');
    const std::uint32_t last = previous().end;
    if (!atEnd() && open.inlineItems && slice({open.name.begin, last}).find_first_of("\r\n") == std::string_view::npos) {
        const std::string line = " at the end of line " + std::to_string(m_tokens.source().position(last).line);
        fix(d, "insert `}`" + (newLine() ? line : std::string()), {edit({last, last}, " }")});
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
