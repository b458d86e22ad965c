#include "lang/parsing/data_formats.h"

#include "lang/characters.h"
#include "lang/parsing/brace_balance.h"
#include "lang/parsing/control_flow.h"

namespace trundle {

/// A block with `extra` tokens before its `{`, whose kind and name are others than the order of these says.
void DataFormats::swappedBlock(std::vector<Item>& out, int depth, std::size_t extra, const Name& type, const Name& own) {
    const std::size_t before = out.size();
    m_grammar.block(out, depth, extra);
    if (out.size() == before || !out.back().as<BlockItem>()) return;
    auto& block = std::get<BlockItem>(out.back().node);
    block.type = type;
    block.name = own;
}

/// `DEF a Robot {`.
bool DataFormats::namedByDef(std::vector<Item>& out, int depth) {
    if (text() != "DEF" || kind(1) != TokenKind::Word || kind(2) != TokenKind::Word || kind(3) != TokenKind::OpenBrace)
        return false;
    const Name own = name(1), type = name(2);
    const TextRange all{range().begin, type.range.end};
    const std::string meant = type.text + " " + own.text;
    Diagnostic& d = error(Code::UnexpectedText, all, "a block begins with its kind: `" + meant + " {`");
    fix(d, meant, {edit(all, meant)});
    advance();
    swappedBlock(out, depth, 1, type, own);
    return true;
}

/// `w = Hinge(Parent=b, Child=c)` as a block; none if it has more in it than a list of properties.
std::vector<TextEdit> DataFormats::repairedCall() const {
    constexpr std::size_t kFar = 200;
    std::vector<TextEdit> edits{edit({range().begin, range(3).end}, std::string(text(2)) + " " + std::string(text()) + " { ")};
    int parens = 0;
    for (std::size_t i = 4; i < kFar; ++i) {
        const TokenKind k = kind(i);
        if (k == TokenKind::ExprOpen || (k == TokenKind::OpenParen && parens > 0)) ++parens;
        else if (k == TokenKind::CloseParen && parens > 0) --parens;
        else if (k == TokenKind::CloseParen) return edits.push_back(edit(range(i), " }")), edits;
        else if (k == TokenKind::Comma && parens == 0 && startsItem(i + 1))
            edits.push_back(edit(range(i), adjacent(i + 1) ? " " : ""));
        else if (k == TokenKind::OpenParen || k == TokenKind::OpenBrace || k == TokenKind::CloseBrace ||
                 k == TokenKind::Unknown || k == TokenKind::End)
            return {};
    }
    return {};
}

bool DataFormats::called(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::Equals || kind(2) != TokenKind::Word || kind(3) != TokenKind::OpenParen || newLine(3)) return false;
    if (isCapital(text()) || !isCapital(text(2)) || !startsItem(4)) return false;
    const Name own = name(), type = name(2);
    Diagnostic& d =
        error(Code::UnexpectedText, {own.range.begin, type.range.end},
              "a block begins with its kind and has no commas: `" + type.text + " " + own.text + " { Key=value ... }`");
    if (std::vector<TextEdit> edits = repairedCall(); !edits.empty())
        fix(d, type.text + " " + own.text + " { ... }", std::move(edits));
    m_report.setSilent(true);
    swappedBlock(out, depth, 2, type, own);
    m_report.setSilent(false);
    return true;
}

/// `Body chassis = Box {`.
bool DataFormats::nested(std::vector<Item>& out, int depth) {
    for (const std::size_t i : {0, 1, 3})
        if (kind(i) != TokenKind::Word) return false;
    if (kind(2) != TokenKind::Equals || kind(4) != TokenKind::OpenBrace || newLine(4)) return false;
    const std::string_view type = text();
    if (!isCapital(type) || !isCapital(text(3)) || type == "Param" || type == "Robot" || type == "Static" || type == "Part" ||
        type.ends_with("Config"))
        return false;
    BlockItem outer;
    const std::uint32_t begin = range().begin;
    outer.type = name();
    outer.name = name(1);
    outer.open = {range(2).begin, range(2).begin};
    const std::string head = outer.type.text + " " + outer.name->text, inner(text(3));
    const TextRange sign = range(2);
    Diagnostic& d = error(Code::UnexpectedText, {sign.begin, range(3).end},
                          "a block in another one is written in its { }: `" + head + " { " + inner + " { ... } }`");
    const std::size_t index = m_report.indexOf(d);
    for (int i = 0; i < 3; ++i) advance();
    m_grammar.block(outer.items, depth, 0);
    const std::uint32_t end = previous().end;
    if (index > 0) fix(m_report.at(index), "{ " + inner + " { ... } }", {edit(sign, "{"), edit({end, end}, " }")});
    outer.close = {end, end};
    out.push_back({{begin, end}, std::move(outer)});
    return true;
}

/// `children [ Shape { } ]`.
bool DataFormats::children() {
    if (text(1) != "[" || newLine(1) || isCapital(text())) return false;
    const bool holdsBlocks = kind(2) == TokenKind::Word && (kind(3) == TokenKind::OpenBrace || kind(3) == TokenKind::Word);
    if (!holdsBlocks) return false;
    error(Code::UnexpectedText, {range().begin, range(1).end},
          "there are no lists of blocks: they are in the { } of the block that they belong to, as in `Body b { Box { ... } }`");
    advance();
    skipBrackets();
    return true;
}

/// Skips the bracket or brace here and all up to its end.
void DataFormats::skipBrackets() {
    int open = 0;
    do {
        const bool opens = kind() == TokenKind::OpenBrace || text() == "[";
        const bool closes = kind() == TokenKind::CloseBrace || text() == "]";
        if (closes && open == 0) return;
        open += opens ? 1 : closes ? -1 : 0;
        advance();
    } while (open > 0 && !atEnd());
}

/// `"Mass": 1, "wheel": { ... },`.
bool DataFormats::json() {
    if (kind() != TokenKind::String || text(1) != ":") return false;
    error(Code::UnexpectedText, {range().begin, range(1).end},
          "keys in quotes are of JSON: here a block is written `Body name { ... }`, a property `Mass = 2`");
    while (kind() == TokenKind::String && text(1) == ":") {
        advance();
        advance();
        do {
            if (kind() == TokenKind::CloseBrace) return true;
            if (kind() == TokenKind::OpenBrace || text() == "[") skipBrackets();
            else advance();
        } while (!atEnd() && !newLine() && kind() != TokenKind::Comma);
        if (kind() == TokenKind::Comma) advance();
    }
    return true;
}

/// `- Hinge: w` and the lines that belong to it.
bool DataFormats::yaml() {
    if (kind() != TokenKind::Minus || !newLine() || kind(1) != TokenKind::Word || newLine(1) || text(2) != ":") return false;
    const bool kindFirst = isCapital(text(1)) && kind(3) == TokenKind::Word && !newLine(3);
    const std::string block = kindFirst ? std::string(text(1)) + " " + std::string(text(3)) : "Body name";
    const int indent = m_balance.indentOf(range().begin);
    error(Code::UnexpectedText, {range().begin, range(2).end},
          "lists with `-` are of YAML: here a block is written `" + block + " { ... }`, a property `Mass = 2`");
    do advance();
    while (!atEnd() && !newLine() && kind() != TokenKind::CloseBrace);
    if (newLine()) m_flow.skipIndented(indent, "-");
    return true;
}

} // namespace trundle
