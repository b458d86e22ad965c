#include "lang/parsing/missing_braces.h"

#include <algorithm>

#include "lang/characters.h"
#include "lang/parsing/brace_balance.h"

namespace trundle {

/// Reports the `{` that is missing behind the kind and name that begin here.
Diagnostic& MissingBraces::expected(bool named) {
    const std::string what = std::string(text()) + (named ? " " + std::string(text(1)) : "");
    return error(Code::UnexpectedText, range(named ? 1 : 0), "`{` expected after `" + what + "`");
}

bool MissingBraces::assumed(std::vector<Item>& out, int depth) {
    if (!isCapital(text()) || text() == "Param" || newLine(1) || kind(1) != TokenKind::Word) return false;
    const bool named = !startsItem(1);
    if (kind(2) == TokenKind::OpenBrace || (!named && (!isCapital(text(1)) || kind(3) == TokenKind::OpenBrace))) return false;
    const std::size_t first = named ? 2 : 1;
    const bool empty = named && kind(first) == TokenKind::CloseBrace;
    if (kind(first) != TokenKind::Word && !empty) return false;
    const bool block = kind(first + 1) == TokenKind::Word && kind(first + 2) == TokenKind::OpenBrace;
    if (!newLine(first) && !startsItem(first) && !block && !empty) return false;
    if (!m_balance.isOpened(position())) return m_balance.recordNoBrace(position()), false;
    const TextRange last = range(first - 1);
    fix(expected(named), std::string(slice(last)) + " {", {edit({last.end, last.end}, " {")});
    blockWithoutBrace(out, depth, named);
    return true;
}

bool MissingBraces::assumedDescription(const ParamItem& param) {
    if (kind() != TokenKind::Word || (kind(1) != TokenKind::Equals && !wrongEquals(1))) return false;
    if (text() != "Min" && text() != "Max" && text() != "Choices" && text() != "Help") return false;
    if (!m_balance.isOpened(position())) return m_balance.recordNoBrace(position()), false;
    const TextRange value = param.value.range;
    Diagnostic& d = error(Code::UnexpectedText, value, "`{` expected after the value of `Param " + param.name.text + "`");
    fix(d, "insert `{`", {edit({value.end, value.end}, " {")});
    return true;
}

bool MissingBraces::beforeIndented(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::Word || newLine(1)) return false;
    const int indent = m_balance.indentOf(range().begin);
    if (indent < 0 || kind(2) == TokenKind::End || !newLine(2) || m_balance.indentOf(range(2).begin) <= indent) return false;
    fix(expected(true), std::string(text(1)) + " {", {edit({range(1).end, range(1).end}, " {")});
    blockWithoutBrace(out, depth, true);
    return true;
}

bool MissingBraces::byIndentation(std::vector<Item>& out, int depth) {
    const std::size_t colon = kind(1) == TokenKind::Word ? 2 : 1, below = colon + 1;
    if (text(colon) != ":" || newLine(1) || newLine(colon) || !newLine(below) || kind(below) == TokenKind::End) return false;
    const int indent = m_balance.indentOf(range().begin);
    if (indent < 0 || m_balance.indentOf(range(below).begin) <= indent) return false;
    const std::string what = isCapital(text()) ? std::string(slice({range().begin, range(colon - 1).end})) : "Body name";
    m_report.indentation({range().begin, range(colon).end},
                         "blocks by indentation are of YAML and Python: here a block is written `" + what +
                             " { ... }`, a property `Mass = 2`");
    if (isCapital(text())) blockWithoutBrace(out, depth, colon == 2, true);
    else skipIndented(indent); // it has no kind
    return true;
}

void MissingBraces::skipIndented(int indent) {
    int braces = 0;
    do {
        if (kind() == TokenKind::OpenBrace) ++braces;
        if (kind() == TokenKind::CloseBrace && --braces < 0) return;
        advance();
    } while (!atEnd() && !(newLine() && m_balance.indentOf(range().begin) <= indent));
}

/// The first of two blocks lacks its `{`; surely so if a `}` of this line has none either.
bool MissingBraces::beforeBlock(std::vector<Item>& out, int depth) {
    for (std::size_t i = 1; i < 4; ++i)
        if (kind(i) != TokenKind::Word || newLine(i)) return false;
    if (kind(4) != TokenKind::OpenBrace) return false;
    constexpr std::size_t kFar = 200;
    int surplus = 0; // of `}` in the lines from here to the end of the inner block
    for (std::size_t i = 4; i < kFar && kind(i) != TokenKind::End && !(newLine(i) && surplus >= 0); ++i)
        surplus += kind(i) == TokenKind::CloseBrace ? 1 : kind(i) == TokenKind::OpenBrace ? -1 : 0;
    for (std::size_t i = position(); i > 0 && position() - i < kFar && !m_tokens.newLineAt(i); --i) {
        const TokenKind before = m_tokens.at(i - 1).kind; // what this line opened before
        surplus -= before == TokenKind::OpenBrace ? 1 : before == TokenKind::CloseBrace ? -1 : 0;
    }
    Diagnostic& d = expected(true);
    if (surplus > 0) {
        fix(d, std::string(text(1)) + " {", {edit({range(1).end, range(1).end}, " {")});
        blockWithoutBrace(out, depth, true);
    } else {
        advance();
        advance();
    }
    return true;
}

/// A kind and perhaps a name without `{`; what follows up to its `}`, or is indented deeper below, forms its body.
void MissingBraces::blockWithoutBrace(std::vector<Item>& out, int depth, bool named, bool byIndentation) {
    BlockItem node;
    OpenBlock open;
    const std::uint32_t begin = range().begin;
    open.indent = m_balance.indentOf(begin);
    open.byIndentation = byIndentation;
    node.type = name();
    if (named) node.name = name(1);
    open.name = named ? node.name->range : node.type.range;
    if (named) advance();
    if (byIndentation) advance();
    open.openAt = static_cast<std::uint32_t>(position());
    advance();
    node.open = {open.name.end, open.name.end};
    if (depth + 1 > kMaxBlockDepth) return;
    m_balance.open(open);
    m_grammar.blockBody(node, depth);
    m_balance.close();
    out.push_back({{begin, std::max(node.close.end, node.open.end)}, std::move(node)});
}

} // namespace trundle
