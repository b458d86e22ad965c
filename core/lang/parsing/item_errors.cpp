#include "lang/parsing/item_errors.h"

#include <algorithm>

#include "lang/characters.h"
#include "lang/parsing/brace_balance.h"

namespace trundle {
namespace {

constexpr std::size_t kShortText = 40;

std::string shortened(std::string_view text) {
    if (text.size() <= kShortText) return std::string(text);
    std::size_t cut = kShortText;
    while (cut > 0 && (static_cast<unsigned char>(text[cut]) & 0xC0) == 0x80) --cut;
    return std::string(text.substr(0, cut)) + "...";
}

} // namespace

/// `c */` after a nested comment: the comment ended at its first `*/`.
bool ItemErrors::restOfComment() {
    constexpr std::size_t kFar = 50;
    for (std::size_t i = 1; i < kFar && !newLine(i); ++i) {
        if (kind(i) == TokenKind::End || kind(i) == TokenKind::OpenBrace || kind(i) == TokenKind::CloseBrace) return false;
        if (kind(i) != TokenKind::Unknown || text(i) != "*/") continue;
        error(Code::UnclosedComment, range(i), "comments do not nest: this one ended at its first `*/`");
        for (; i > 0; --i) advance();
        advance();
        return true;
    }
    return false;
}

void ItemErrors::strayWord(std::vector<Item>& out, int depth) {
    if (restOfComment() || quotedName(out, depth) || nameThatBeginsWithDigit(out, depth) || missingEquals(out) ||
        blockInBrackets(out, depth) || nameWithSigns(out, depth) || nameOfTwoWords(out, depth) ||
        m_braces.beforeIndented(out, depth) || m_braces.beforeBlock(out, depth) || keyAndWord(out, depth))
        return;
    const std::string word(text());
    const bool named = kind(1) == TokenKind::Word && !newLine(1) && newLine(2);
    const std::string what = named ? word + " " + std::string(text(1)) : word;
    const TextRange where{range().begin, named ? range(1).end : range().end};
    error(Code::UnexpectedText, where,
          named ? "`{` expected after `" + shortened(what) + "`" : "`=` or `{` expected after `" + shortened(what) + "`");
    if (named) advance();
    skipLine();
}

/// `Robot "r" {`. This and the following functions return false if there is no such text here.
bool ItemErrors::quotedName(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::String || kind(2) != TokenKind::OpenBrace) return false;
    Diagnostic& d = error(Code::UnexpectedText, range(1), "a name is written without quotes");
    const std::string_view quoted = text(1);
    const std::string bare(quoted.substr(1, quoted.size() - 2));
    if (!bare.empty() && isIdentStart(bare[0]) && std::all_of(bare.begin(), bare.end(), isIdent))
        fix(d, bare, {edit(range(1), bare)});
    m_grammar.block(out, depth, 1);
    return true;
}

/// `Robot 2nd {`.
bool ItemErrors::nameThatBeginsWithDigit(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::Number) return false;
    const bool numberAndWord =
        (kind(2) == TokenKind::Unit || kind(2) == TokenKind::Word) && adjacent(2) && kind(3) == TokenKind::OpenBrace;
    if (kind(2) != TokenKind::OpenBrace && !numberAndWord) return false;
    const std::size_t tokens = numberAndWord ? 2 : 1;
    error(Code::UnexpectedText, {range(1).begin, range(tokens).end}, "a name begins with a letter or _");
    m_grammar.block(out, depth, tokens);
    return true;
}

/// `Tick 0.01`.
bool ItemErrors::missingEquals(std::vector<Item>& out) {
    const bool startsValue = kind(1) == TokenKind::Number || kind(1) == TokenKind::String || kind(1) == TokenKind::ParamRef ||
                             kind(1) == TokenKind::ExprOpen;
    if (newLine(1) || !startsValue) return false;
    const std::string word(text());
    Diagnostic& d = error(Code::UnexpectedText, range(), "`=` expected after `" + word + "`");
    fix(d, word + " =", {edit({range().end, range().end}, adjacent(1) ? "=" : " =")});
    const std::size_t fault = m_report.indexOf(d);
    readValue(out);
    m_report.mergeNext(fault, Code::MissingComma, word + " = ");
    return true;
}

void ItemErrors::keyWithoutEquals(std::vector<Item>& out) {
    const std::string word(text());
    Diagnostic& d = error(Code::UnexpectedText, range(), "`=` expected after `" + word + "`");
    fix(d, word + "=", {edit({range().end, range(1).begin}, "=")});
    const std::size_t fault = m_report.indexOf(d);
    readValue(out);
    m_report.mergeNext(fault, Code::MissingComma, word + "=");
}

/// `Config A` in a block, with nothing below it that would be the items of a block A.
bool ItemErrors::keyAndWord(std::vector<Item>& out, int depth) {
    if (depth == 0 || kind(1) != TokenKind::Word || newLine(1) || !isCapital(text())) return false;
    const bool isNumberNext = kind(2) == TokenKind::Word && kind(3) == TokenKind::Number; // `Config A Mass 1`
    if (kind(2) != TokenKind::CloseBrace && !newLine(2) && !startsItem(2) && !isNumberNext) return false;
    const std::string word(text());
    Diagnostic& d = error(Code::UnexpectedText, range(), "`=` or `{` expected after `" + word + "`");
    fix(d, word + "=", {edit({range().end, range(1).begin}, "=")});
    readValue(out);
    return true;
}

/// Reads the value of the current word, a key without its `=`.
void ItemErrors::readValue(std::vector<Item>& out) {
    AssignmentItem node;
    const TextRange key = range();
    const std::string word(text());
    for (std::size_t at = 0, dot = 0; dot != std::string::npos; at = dot + 1) { // here `b.Size` is one word
        dot = word.find('.', at);
        const auto begin = static_cast<std::uint32_t>(key.begin + at);
        node.path.push_back({word.substr(at, dot - at),
                             {begin, dot == std::string::npos ? key.end : static_cast<std::uint32_t>(key.begin + dot)}});
        m_grammar.rejectReserved(node.path.back(), "a key");
    }
    node.pathRange = key;
    advance();
    node.value = m_grammar.value(word, key, {key.end, key.end});
    out.push_back({{key.begin, std::max(key.end, node.value.range.end)}, std::move(node)});
}

/// `Robot my robot {`.
bool ItemErrors::nameOfTwoWords(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::Word || newLine(1)) return false;
    if (kind(2) != TokenKind::Word || kind(3) != TokenKind::OpenBrace || newLine(2)) return false;
    if (isCapital(text(1)) && !isCapital(text())) { // `new Body b {`
        Diagnostic& d = error(Code::UnexpectedText, range(),
                              "`" + std::string(text()) + "` does not belong before `" + std::string(text(1)) + " " +
                                  std::string(text(2)) + "`");
        fix(d, "remove `" + std::string(text()) + "`", {edit({range().begin, range(1).begin}, "")});
        advance();
        m_grammar.block(out, depth, 1);
        return true;
    }
    const TextRange names{range(1).begin, range(2).end};
    Diagnostic& d = error(Code::UnexpectedText, names, "a name is one word");
    const std::string joined = std::string(text(1)) + "_" + std::string(text(2));
    fix(d, joined, {edit(names, joined)});
    m_grammar.block(out, depth, 2);
    return true;
}

/// `Robot r [ ... ]` or `Robot r ( ... )`.
bool ItemErrors::blockInBrackets(std::vector<Item>& out, int depth) {
    const auto bracketAt = [this](std::size_t i) {
        if (newLine(i) || !(kind(i) == TokenKind::OpenParen || (kind(i) == TokenKind::Unknown && text(i) == "["))) return false;
        return newLine(i + 1) || (kind(i + 1) == TokenKind::Word && kind(i + 2) == TokenKind::Equals);
    };
    const bool named = kind(1) == TokenKind::Word && !newLine(1);
    if (!bracketAt(named ? 2 : 1)) return false;
    m_grammar.block(out, depth, named ? 1 : 0);
    return true;
}

/// `Robot r-1 {`.
bool ItemErrors::nameWithSigns(std::vector<Item>& out, int depth) {
    if (kind(1) != TokenKind::Word || newLine(1)) return false;
    constexpr std::size_t kMaxPieces = 20;
    std::size_t brace = 2;
    while (brace < kMaxPieces && isPieceOfName(brace)) ++brace;
    if (brace == 2 || kind(brace) != TokenKind::OpenBrace) return false;
    const TextRange names{range(1).begin, range(brace - 1).end};
    Diagnostic& d = error(Code::UnexpectedText, names, "a name is letters, digits and _");
    std::string joined(slice(names));
    for (char& c : joined)
        if (!isIdent(c)) c = '_';
    fix(d, joined, {edit(names, joined)});
    m_grammar.block(out, depth, brace - 1);
    return true;
}

/// Skips the current token and all up to the next line, key, kind, brace or directive.
void ItemErrors::skipLine() {
    advance();
    while (!atEnd() && !newLine() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace &&
           kind() != TokenKind::Directive && !startsItem() && !namedBlock())
        advance();
}

void ItemErrors::strayBrace(bool tooEarly) {
    if (!tooEarly) m_balance.recordUnmatched();
    Diagnostic& d =
        error(Code::StrayBrace, range(),
              tooEarly ? "one `}` too many: the indentation suggests that the block continues" : "this `}` has no matching `{`");
    fix(d, "remove `}`", {edit(range(), "")});
    advance();
}

void ItemErrors::unexpected(int depth) {
    if (explainUnexpected()) return;
    if (kind() == TokenKind::OpenBrace) {
        error(Code::StrayBrace, range(), "a block needs its kind before `{`");
        BlockItem dropped;
        OpenBlock open;
        open.name = range();
        open.openAt = static_cast<std::uint32_t>(position());
        advance();
        if (depth + 1 > kMaxBlockDepth) return m_grammar.skipBlockBody();
        m_balance.open(open);
        m_grammar.blockBody(dropped, depth);
        m_balance.close();
        return;
    }
    TextRange r = range();
    bool first = true;
    while (!atEnd() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace && kind() != TokenKind::Directive &&
           (first || (!newLine() && !startsItem() && !namedBlock() && text() != ";"))) {
        r.end = range().end;
        first = false;
        advance();
    }
    const bool number = r.begin < r.end && isDigit(bytes()[r.begin]);
    error(Code::UnexpectedText, r,
          number ? "a number cannot begin a line here; a list continues on the next line only after a comma"
                 : "syntax error: unexpected `" + shortened(slice(r)) + "`");
}

/// Reports single tokens that have a message of their own.
bool ItemErrors::explainUnexpected() {
    const std::string_view sign = text();
    if (kind() == TokenKind::Comma) {
        m_report.comma(range(), "this comma belongs to no value", Code::UnexpectedText);
        advance();
        return true;
    }
    if (kind() != TokenKind::Unknown) return false;
    if (sign == ";") {
        m_report.semicolon(range());
    } else if (sign == "*/") {
        error(Code::UnclosedComment, range(), "`*/` without `/*`; comments do not nest");
    } else if (sign[0] == '#') {
        Diagnostic& d = error(Code::UnexpectedText, {range().begin, range().begin + 1}, "a comment begins with //");
        fix(d, "//", {edit(d.range.range, "//")});
    } else {
        return false;
    }
    advance();
    return true;
}

} // namespace trundle
