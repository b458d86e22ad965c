#include "lang/parsing/control_flow.h"

#include <set>

#include "lang/characters.h"
#include "lang/parsing/brace_balance.h"

namespace trundle {
namespace {

constexpr const char* kRepeat =
    "blocks that are there several times belong in `Repeat name { Count=4 ... }`, with $(index) in their values";

constexpr const char* kCondition = "a block cannot depend on a condition, a value can: $(if(a > b, x, y))";

} // namespace

/// `for i = 1 to 4 {`, `if $n > 3 {`: what it would repeat is skipped, since its names and values make no sense alone.
bool ControlFlow::loop() {
    if (array()) return true;
    static const std::set<std::string_view> kLoops{"for", "foreach", "while", "repeat", "loop"};
    const std::string word(text());
    if ((!kLoops.contains(word) && word != "if") || newLine(1)) return false;
    const std::size_t brace = braceInLine();
    error(Code::UnexpectedText, range(), word == "if" ? kCondition : "there is no `" + word + "`: " + kRepeat);
    if (brace == 0) {
        const int indent = m_balance.indentOf(range().begin);
        do advance();
        while (!atEnd() && !newLine() && kind() != TokenKind::CloseBrace);
        if (newLine() && indent >= 0) skipIndented(indent, "else");
        static const std::set<std::string_view> kEnds{"end", "endfor", "endif", "endwhile", "done", "fi", "next"};
        if (newLine() && newLine(1) && kEnds.contains(text())) advance();
        return true;
    }
    for (std::size_t i = 0; i <= brace; ++i) advance();
    m_grammar.skipBlockBody();
    if (word == "if") otherwise();
    return true;
}

/// `Body[4] wheel {`, `Body wheel[4] {`: the block is skipped.
bool ControlFlow::array() {
    const std::size_t first = text(1) == "[" ? 1 : 2, brace = braceInLine();
    if (!isCapital(text()) || text(first) != "[" || text(first + 2) != "]" || brace < first + 3 || brace > first + 4)
        return false;
    error(Code::UnexpectedText, {range(first).begin, range(first + 2).end}, kRepeat);
    for (std::size_t i = 0; i <= brace; ++i) advance();
    m_grammar.skipBlockBody();
    return true;
}

/// `else {`, `else if a > b {` behind an `if`, which is reported for all of them.
void ControlFlow::otherwise() {
    while (kind() == TokenKind::Word && (text() == "else" || text() == "elseif" || text() == "elif")) {
        const std::size_t brace = braceInLine();
        if (brace == 0) return;
        for (std::size_t i = 0; i <= brace; ++i) advance();
        m_grammar.skipBlockBody();
    }
}

/// `def wheel(r) {`, `class Wheel {`: the block is skipped.
bool ControlFlow::definition() {
    static const std::set<std::string_view> kWords{"class",  "def",    "func",     "function", "macro",
                                                   "module", "struct", "template", "xacro"};
    if (isCapital(text()) || kind(1) != TokenKind::Word || newLine(1) || !kWords.contains(text())) return false;
    const std::size_t brace = braceInLine();
    const int indent = m_balance.indentOf(range().begin);
    if (brace == 0 && (indent < 0 || (text(2) != ":" && kind(2) != TokenKind::OpenParen))) return false;
    if (brace > 0 && kind(2) != TokenKind::OpenBrace && kind(2) != TokenKind::OpenParen) return false;
    error(Code::UnexpectedText, range(),
          "there is no `" + std::string(text()) +
              "`: what is used several times is a `PartConfig Wheel { Param r=0.05 ... }`, each use a `Part left { Config=Wheel "
              "}`");
    if (brace == 0) { // of Python
        do advance();
        while (!atEnd() && !newLine() && kind() != TokenKind::CloseBrace);
        if (newLine()) skipIndented(indent);
        return true;
    }
    for (std::size_t i = 0; i <= brace; ++i) advance();
    m_grammar.skipBlockBody();
    if (text() == ";") advance();
    return true;
}

void ControlFlow::skipIndented(int indent, std::string_view sign) {
    int braces = 0;
    while (!atEnd()) {
        if (newLine() && braces == 0) {
            const int here = m_balance.indentOf(range().begin);
            if (here < indent || (here == indent && (sign.empty() || text() != sign))) return;
        }
        braces += kind() == TokenKind::OpenBrace ? 1 : kind() == TokenKind::CloseBrace ? -1 : 0;
        if (braces < 0) return;
        advance();
    }
}

/// Whether `{% word` is here, also with a sign behind its `%`.
bool ControlFlow::tagAhead(std::string_view word) const {
    if (kind() != TokenKind::OpenBrace || text(1) != "%" || !adjacent(1)) return false;
    return text(kind(2) == TokenKind::Minus ? 3 : 2).starts_with(word);
}

/// Skips `{% ... %}`.
void ControlFlow::skipTag() {
    while (!atEnd() && kind() != TokenKind::CloseBrace) advance();
    if (!atEnd()) advance();
}

bool ControlFlow::markup() {
    if (!tagAhead("")) return false;
    const bool isLoop = tagAhead("for"), isCondition = tagAhead("if");
    error(Code::UnexpectedText, {range().begin, range(1).end},
          isLoop        ? std::string("there is no `{% for %}`: ") + kRepeat
          : isCondition ? kCondition
                        : "there is no `{% %}`: a named value is written `Param name = value`");
    int depth = 0;
    do {
        depth += tagAhead("for") || tagAhead("if") ? 1 : tagAhead("end") ? -1 : 0;
        if (tagAhead("")) skipTag();
        else advance();
    } while (depth > 0 && !atEnd());
    return true;
}

} // namespace trundle
