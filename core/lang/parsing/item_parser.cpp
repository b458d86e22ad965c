#include "lang/parsing/item_parser.h"

#include <algorithm>

#include "lang/characters.h"

namespace trundle {
namespace {

bool isReserved(std::string_view word) { return word == "Param" || word == "true" || word == "false" || word == "world"; }

bool isName(std::string_view word) {
    return !word.empty() && isIdentStart(word[0]) && std::all_of(word.begin(), word.end(), isIdent);
}

} // namespace

void ItemParser::rejectReserved(const Name& name, std::string_view use) {
    if (isReserved(name.text))
        error(Code::ReservedWord, name.range, "`" + name.text + "` is reserved and cannot be " + std::string(use));
    else if (!isName(name.text))
        error(Code::UnexpectedText, name.range, "`" + name.text + "` cannot be " + std::string(use) + ": only A-Z a-z 0-9 and _");
}

void ItemParser::items(std::vector<Item>& out, int depth) {
    while (!atEnd()) {
        m_tokens.beginItem();
        if (depth > 0 && m_balance.closedHere(m_balance.innermost())) return;
        if (depth > 0 && m_balance.foreignClose()) return;
        if (!out.empty() && m_balance.isInDescription() && (text() == "Param" || namedBlock())) return; // it holds none
        if (depth > 0) m_balance.recordIndent();
        switch (kind()) {
        case TokenKind::CloseBrace:
            if (depth > 0 && !m_balance.isIgnored()) return;
            m_errors.strayBrace(depth > 0);
            break;
        case TokenKind::Directive: m_directives.directive(out); break;
        case TokenKind::Word: item(out, depth); break;
        default:
            if (!m_otherLanguages.explainSign()) m_errors.unexpected(depth);
            break;
        }
    }
}

void ItemParser::item(std::vector<Item>& out, int depth) {
    const TokenKind second = kind(1);
    const auto opensBlock = [this](std::size_t i) { // `chassis = { Mass=1 }`; with a number inside, it is a list in braces
        return (kind(i) == TokenKind::Equals || wrongEquals(i)) && kind(i + 1) == TokenKind::OpenBrace &&
               (kind(i + 2) == TokenKind::Word || kind(i + 2) == TokenKind::CloseBrace);
    };
    if (m_errors.braces().assumed(out, depth) || m_errors.braces().byIndentation(out, depth)) return;
    const bool isPiece = kind(2) == TokenKind::ParamRef || kind(2) == TokenKind::ExprOpen || isBracedParam(text(2));
    if (second == TokenKind::Word && adjacent(2) && isPiece && m_otherLanguages.computedName(out, depth)) return; // `Body q$i {`
    if (m_values.keyAt() == position()) return m_errors.keyWithoutEquals(out);
    if (m_paramErrors.otherForm(out)) return;
    if (text() == "Param" && (second == TokenKind::Word || second == TokenKind::ParamRef || isBracedParam(text(1))))
        return param(out, depth);
    if (m_paramErrors.withoutName() || m_otherLanguages.misread(out, depth)) return;
    if (second == TokenKind::OpenBrace) return block(out, depth, 0);
    if (second == TokenKind::Word && kind(2) == TokenKind::OpenBrace) return block(out, depth, 1);
    for (std::size_t i = 1; i <= (second == TokenKind::Word ? 2u : 1u); ++i) {
        if (!opensBlock(i)) continue;
        const std::string sign(text(i));
        Diagnostic& d = error(Code::UnexpectedText, range(i), "a block has no `" + sign + "` before its `{`");
        fix(d, "remove `" + sign + "`", {edit(range(i), "")});
        return block(out, depth, i);
    }
    if (second == TokenKind::Equals || second == TokenKind::Dot || wrongEquals(1)) return assignment(out);
    if (!m_otherLanguages.explain(out, depth) && !m_paramErrors.otherWord(out, depth)) m_errors.strayWord(out, depth);
}

void ItemParser::assignment(std::vector<Item>& out) {
    AssignmentItem node;
    const std::uint32_t begin = range().begin;
    if (!m_pathErrors.names(node.path)) node.path.push_back(name());
    const TextRange whole = range();
    advance();
    while (kind() == TokenKind::Dot && kind(1) == TokenKind::Word && !newLine() && !newLine(1)) {
        node.path.push_back(name(1));
        advance();
        advance();
    }
    node.pathRange = {begin, std::max(whole.end, node.path.back().range.end)};
    if (kind() == TokenKind::OpenBrace) {
        error(Code::UnexpectedText, node.pathRange,
              "a block has no dotted name; to change a property write `" + std::string(slice(node.pathRange)) +
                  ".Property = value`");
        advance();
        return skipBlockBody();
    }
    if (kind() != TokenKind::Equals && !wrongEquals(0)) {
        Diagnostic& d =
            error(Code::UnexpectedText, node.pathRange, "`=` expected after `" + std::string(slice(node.pathRange)) + "`");
        if (kind() == TokenKind::Dot) d.range.range.end = range().end;
        if (!newLine() && startsElement() && kind() != TokenKind::Word) {
            const TextRange key = node.pathRange;
            fix(d, std::string(slice(key)) + " =", {edit({key.end, key.end}, " =")});
            node.value = value(slice(key), key, {key.end, key.end});
            return out.push_back({{begin, std::max(key.end, node.value.range.end)}, std::move(node)});
        }
        // The rest of the line belongs to the unreadable text.
        while (!atEnd() && !newLine() && !startsItem() && !namedBlock() && kind() != TokenKind::CloseBrace &&
               kind() != TokenKind::OpenBrace && kind() != TokenKind::Directive)
            advance();
        return;
    }
    for (const Name& part : node.path) rejectReserved(part, "a key");
    if (wrongEquals(0) && !m_balance.isByIndentation()) m_report.wrongEquals(range(), text(), adjacent());
    const TextRange equals = range();
    advance();
    const std::string path(slice(node.pathRange));
    const TextRange pathRange = node.pathRange;
    node.value = value(path, pathRange, equals);
    out.push_back({{begin, std::max(equals.end, node.value.range.end)}, std::move(node)});
}

void ItemParser::param(std::vector<Item>& out, int depth) {
    ParamItem node;
    const std::uint32_t begin = range().begin;
    const std::optional<Name> meant = m_paramErrors.dollarName();
    advance();
    node.name = meant ? *meant : name();
    advance();
    if (!m_paramErrors.restOfName(node.name)) rejectReserved(node.name, "a Param");
    TextRange equals = {node.name.range.end, node.name.range.end};
    if (kind() == TokenKind::Equals) {
        equals = range();
        advance();
    } else {
        const bool wrong = wrongEquals(0);
        Diagnostic& d = error(Code::UnexpectedText, wrong ? range() : node.name.range,
                              wrong ? "`=` expected, not `" + std::string(text()) + "`"
                                    : "`=` expected after `Param " + node.name.text + "`");
        if (wrong) fix(d, "=", {edit(range(), "=")});
        else if (!newLine() && startsElement() && !namedBlock())
            fix(d, node.name.text + " =", {edit({equals.end, equals.end}, " =")});
        if (wrong) {
            equals = range();
            advance();
        } else if (newLine() || !startsElement() || namedBlock()) { // it is there nonetheless, so that its uses are no mistakes
            node.value.range = equals;
            node.value.broken = true;
            return out.push_back({{begin, equals.end}, std::move(node)});
        }
    }
    const std::string key = node.name.text;
    node.value = m_values.paramValue(key, node.name.range, equals);
    std::uint32_t end = std::max(equals.end, node.value.range.end);
    const bool inBrackets = !newLine() && (kind() == TokenKind::OpenParen || text() == "[");
    if (inBrackets && m_paramErrors.limitsInBrackets()) {
        end = previous().end;
    } else if (!node.value.elements.empty() &&
               (kind() == TokenKind::OpenBrace || (inBrackets && kind(1) == TokenKind::Word && kind(2) == TokenKind::Equals) ||
                m_errors.braces().assumedDescription(node))) {
        description(node, m_balance.indentOf(begin), depth);
        end = std::max(node.open.end, node.close.end);
    } else {
        m_paramErrors.looseDescription(node);
        end = std::max(end, previous().end);
    }
    out.push_back({{begin, end}, std::move(node)});
}

/// `{ Min=2 cm Help="..." }` behind a Param.
void ItemParser::description(ParamItem& param, int indent, int depth) {
    if (depth + 1 > kMaxBlockDepth) { // of Params in Params, since nothing else is read there
        error(Code::TooDeep, param.name.range, "blocks nest deeper than " + std::to_string(kMaxBlockDepth));
        if (kind() == TokenKind::OpenBrace) advance();
        return skipBlockBody();
    }
    OpenBlock open;
    open.indent = indent;
    open.name = param.name.range;
    open.description = true;
    BlockItem body;
    if (kind() == TokenKind::OpenParen || text() == "[") openBracket(open, "what is said about a Param");
    if (kind() == TokenKind::OpenBrace || open.bracket) {
        body.open = range();
        advance();
    } else {
        body.open = {param.value.range.end, param.value.range.end};
    }
    open.openAt = static_cast<std::uint32_t>(position() - 1);
    bodyOf(open, body, depth);
    param.open = body.open;
    param.close = body.close;
    param.items = std::move(body.items);
}

void ItemParser::block(std::vector<Item>& out, int depth, std::size_t extra) {
    BlockItem node;
    const std::uint32_t begin = range().begin;
    OpenBlock open;
    open.indent = m_balance.indentOf(begin);
    node.type = name();
    if (isReserved(node.type.text) || !isName(node.type.text)) rejectReserved(node.type, "a kind");
    advance();
    if (extra > 0 && kind() != TokenKind::Equals && !wrongEquals(0)) {
        const bool two = extra > 1 && kind(1) != TokenKind::Equals && !wrongEquals(1);
        const TextRange r{range().begin, range(two ? extra - 1 : 0).end};
        node.name = {std::string(slice(r)), r};
        if (kind() == TokenKind::String) std::erase(node.name->text, '"');
        if (kind() == TokenKind::Word && !two) rejectReserved(*node.name, "a name"); // otherwise it was already reported
    }
    for (std::size_t i = 0; i < extra; ++i) advance();
    open.name = node.name ? node.name->range : node.type.range;
    open.openAt = static_cast<std::uint32_t>(position());
    if (kind() != TokenKind::OpenBrace) openBracket(open, "a block");
    node.open = range();
    advance();
    if (depth + 1 > kMaxBlockDepth) {
        error(Code::TooDeep, node.type.range, "blocks nest deeper than " + std::to_string(kMaxBlockDepth));
        skipBlockBody();
        node.close = previous();
    } else {
        bodyOf(open, node, depth);
    }
    out.push_back({{begin, std::max(node.close.end, node.open.end)}, std::move(node)});
}

/// Reports a bracket in place of a `{`. `what`: is written in it.
void ItemParser::openBracket(OpenBlock& open, const char* what) {
    Diagnostic& d =
        error(Code::UnexpectedText, range(), std::string(what) + " is written in { }, not in " + (text() == "[" ? "[ ]" : "( )"));
    fix(d, "{", {edit(range(), previous().end == range().begin ? " {" : "{")});
    open.bracket = true;
    open.bracketFault = m_report.indexOf(d);
}

void ItemParser::bodyOf(const OpenBlock& open, BlockItem& node, int depth) {
    const std::size_t outer = m_report.joinSeparators(open.bracketFault);
    m_balance.open(open);
    blockBody(node, depth);
    m_balance.close();
    m_report.joinSeparators(outer);
}

void ItemParser::blockBody(BlockItem& node, int depth) {
    items(node.items, depth + 1);
    const OpenBlock& open = m_balance.innermost();
    if (m_balance.foreignClose() && !m_balance.closedHere(open)) {
        node.close = range();
        if (open.bracketFault > 0) {
            Fix& both = m_report.at(open.bracketFault).fixes.back();
            both.title = "{ }";
            both.edits.push_back(edit(range(), "}"));
        }
        advance();
        return;
    }
    if (kind() == TokenKind::CloseBrace && !m_balance.closedHere(open)) {
        node.close = range();
        advance();
        m_balance.recordEarlyClose(open.indent, position() - 1);
        return;
    }
    const std::uint32_t end = previous().end;
    node.close = {end, end};
    m_balance.reportUnclosed(open, atEnd() ? static_cast<std::uint32_t>(bytes().size()) : range().begin);
}

void ItemParser::skipBlockBody() {
    std::size_t depth = 1;
    while (!atEnd() && depth > 0) {
        if (kind() == TokenKind::OpenBrace) ++depth;
        if (kind() == TokenKind::CloseBrace) --depth;
        advance();
    }
}

} // namespace trundle
