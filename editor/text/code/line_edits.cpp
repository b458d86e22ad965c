#include "editor/text/code/line_edits.h"

#include <algorithm>
#include <vector>

#include "lang/lexer.h"

namespace trundle {
namespace {

bool isEnd(char c) { return c == '\n' || c == '\r'; }

std::size_t lineBegin(std::string_view text, std::size_t at) {
    if (at > 0 && at < text.size() && text[at - 1] == '\r' && text[at] == '\n') --at;
    while (at > 0 && !isEnd(text[at - 1])) --at;
    return at;
}
/// The position before the line ending.
std::size_t lineStop(std::string_view text, std::size_t at) {
    while (at < text.size() && !isEnd(text[at])) ++at;
    return at;
}
/// The position after the line ending.
std::size_t lineNext(std::string_view text, std::size_t at) {
    at = lineStop(text, at);
    if (at == text.size()) return at;
    return at + (text.substr(at, 2) == "\r\n" ? 2 : 1);
}

std::string_view blanksAt(std::string_view text, std::size_t lineBegin) {
    std::size_t end = lineBegin;
    while (end < text.size() && isBlank(text[end])) ++end;
    return text.substr(lineBegin, end - lineBegin);
}

struct Lines {
    std::size_t begin = 0, stop = 0; ///< stop: before the last line's ending
};
/// The lines that a selection touches, without a last line of which it only touches the beginning.
Lines linesOf(std::string_view text, std::size_t anchor, std::size_t caret) {
    const std::size_t from = std::min(anchor, caret);
    std::size_t to = std::max(anchor, caret);
    const std::size_t begin = lineBegin(text, from);
    if (to > from && lineBegin(text, to) == to) to = to > 1 && text[to - 1] == '\n' && text[to - 2] == '\r' ? to - 2 : to - 1;
    return {begin, lineStop(text, std::max(to, begin))};
}

/// Adds or removes the mark of a comment at the start of each line.
std::string commented(std::string_view lines, std::string_view mark, bool on) {
    std::size_t column = std::string_view::npos;
    for (std::size_t at = 0; at < lines.size(); at = lineNext(lines, at)) {
        const std::size_t blanks = blanksAt(lines, at).size();
        if (at + blanks < lineStop(lines, at)) column = std::min(column, blanks);
    }
    if (column == std::string_view::npos) column = 0;
    std::string result;
    for (std::size_t at = 0; at < lines.size();) {
        const std::size_t next = lineNext(lines, at), stop = lineStop(lines, at);
        std::string_view line = lines.substr(at, next - at);
        const std::size_t blanks = blanksAt(lines, at).size();
        if (at + blanks >= stop) result += line;
        else if (on) result.append(line.substr(0, column)).append(mark).append(" ").append(line.substr(column));
        else {
            std::size_t end = blanks + mark.size();
            if (end < line.size() && line[end] == ' ') ++end;
            result.append(line.substr(0, blanks)).append(line.substr(end));
        }
        at = next;
    }
    return result;
}

bool allCommented(std::string_view lines, std::string_view mark) {
    bool any = false;
    for (std::size_t at = 0; at < lines.size(); at = lineNext(lines, at)) {
        const std::size_t first = at + blanksAt(lines, at).size();
        if (first >= lineStop(lines, at)) continue;
        if (!lines.substr(first).starts_with(mark)) return false;
        any = true;
    }
    return any;
}

} // namespace

std::optional<LineEdit> toggleComment(std::string_view text, std::size_t anchor, std::size_t caret, std::string_view mark) {
    const Lines lines = linesOf(text, anchor, caret);
    const std::string_view before = text.substr(lines.begin, lines.stop - lines.begin);
    const std::string after = commented(before, mark, !allCommented(before, mark));
    if (before == after) return std::nullopt;
    const std::vector<Splice> parts = splicesBetween(before, after);
    const auto moved = [&](std::size_t offset) { // maps an offset across the added or removed characters
        return lines.begin +
               std::min(after.size(), movedOffset(std::clamp(offset, lines.begin, lines.stop) - lines.begin, parts));
    };
    LineEdit edit{{lines.begin, before.size(), after}, moved(anchor), moved(caret)};
    if (anchor != caret) {
        edit.anchor = anchor < caret ? lines.begin : lines.begin + after.size();
        edit.caret = anchor < caret ? lines.begin + after.size() : lines.begin;
    }
    return edit;
}

std::optional<LineEdit> duplicateLines(std::string_view text, std::size_t anchor, std::size_t caret, std::string_view lineEnd) {
    const Lines lines = linesOf(text, anchor, caret);
    std::string copy(lineEnd);
    copy += text.substr(lines.begin, lines.stop - lines.begin);
    return LineEdit{{lines.stop, 0, copy}, std::min(anchor, lines.stop) + copy.size(), std::min(caret, lines.stop) + copy.size()};
}

std::optional<LineEdit> moveLines(std::string_view text, std::size_t anchor, std::size_t caret, int direction) {
    const Lines own = linesOf(text, anchor, caret);
    Lines other;
    if (direction < 0) {
        if (own.begin == 0) return std::nullopt;
        const std::size_t stop =
            own.begin - (own.begin > 1 && text[own.begin - 1] == '\n' && text[own.begin - 2] == '\r' ? 2 : 1);
        other = {lineBegin(text, stop), stop};
    } else {
        const std::size_t next = lineNext(text, own.stop);
        if (next == own.stop) return std::nullopt;
        other = {next, lineStop(text, next)};
    }
    const Lines& first = direction < 0 ? other : own;
    const Lines& second = direction < 0 ? own : other;
    const auto slice = [&](const Lines& l) { return text.substr(l.begin, l.stop - l.begin); };
    const std::string_view between = text.substr(first.stop, second.begin - first.stop);
    std::string swapped(slice(second));
    swapped += between;
    swapped += slice(first);
    const std::ptrdiff_t shift = direction < 0 ? -static_cast<std::ptrdiff_t>(slice(other).size() + between.size())
                                               : static_cast<std::ptrdiff_t>(slice(other).size() + between.size());
    const auto moved = [&](std::size_t offset) {
        return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(std::clamp(offset, own.begin, own.stop)) + shift);
    };
    return LineEdit{{first.begin, second.stop - first.begin, swapped}, moved(anchor), moved(caret)};
}

LineEdit newLine(std::string_view text, std::size_t anchor, std::size_t caret, std::string_view lineEnd, std::string_view step,
                 bool colonOpens) {
    const std::size_t from = std::min(anchor, caret), to = std::max(anchor, caret);
    const std::size_t begin = lineBegin(text, from);
    std::string_view blanks = blanksAt(text, begin);
    blanks = blanks.substr(0, std::min(blanks.size(), from - begin));
    int depth = 0; // net number of blocks opened on this line before the caret
    for (const Token& token : Lexer(text.substr(begin, from - begin)).lex()) {
        if (token.kind == TokenKind::OpenBrace) ++depth;
        if (token.kind == TokenKind::CloseBrace && depth > 0) --depth;
    }
    std::size_t last = from;
    while (last > begin && isBlank(text[last - 1])) --last;
    const bool opens = depth > 0 || (colonOpens && last > begin && text[last - 1] == ':');
    std::string inserted(lineEnd);
    inserted += blanks;
    if (opens) inserted += step;
    const std::size_t place = from + inserted.size();
    std::size_t rest = to;
    while (rest < text.size() && isBlank(text[rest])) ++rest;
    const std::size_t removed = rest - from; // blanks after the caret would add to the indentation
    if (opens && rest < text.size() && text[rest] == '}') {
        inserted += lineEnd;
        inserted += blanks;
    }
    return {{from, removed, inserted}, place, place};
}

std::optional<LineEdit> closeBrace(std::string_view text, std::size_t caret) {
    const std::size_t begin = lineBegin(text, caret);
    if (begin + blanksAt(text, begin).size() < caret) return std::nullopt;
    std::vector<std::uint32_t> open;
    for (const Token& token : Lexer(text.substr(0, begin)).lex()) {
        if (token.kind == TokenKind::OpenBrace) open.push_back(token.range.begin);
        if (token.kind == TokenKind::CloseBrace && !open.empty()) open.pop_back();
    }
    if (open.empty()) return std::nullopt;
    std::string line(blanksAt(text, lineBegin(text, open.back())));
    line += '}';
    const std::size_t place = begin + line.size();
    return LineEdit{{begin, caret - begin, line}, place, place};
}

} // namespace trundle
