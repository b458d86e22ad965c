#include "lang/parsing/param_errors.h"

#include <algorithm>
#include <array>

#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxPieces = 20; ///< tokens of a name with signs

bool isType(std::string_view word) {
    constexpr std::array<std::string_view, 9> kTypes{"bool",   "double", "float",  "int",     "long",
                                                     "number", "real",   "string", "unsigned"};
    return std::ranges::find(kTypes, word) != kTypes.end();
}

bool declares(std::string_view word) {
    constexpr std::array<std::string_view, 8> kWords{"param", "PARAM", "var", "let", "const", "constexpr", "auto", "def"};
    return std::ranges::find(kWords, word) != kWords.end();
}

} // namespace

bool ParamErrors::withoutName() {
    if (text() != "Param" || newLine(1)) return false;
    const TextRange word = range();
    std::size_t equals = 1;
    if (kind(1) == TokenKind::Number)
        for (++equals; equals < kMaxPieces && isPieceOfName(equals);) ++equals;
    const bool assigns = kind(equals) == TokenKind::Equals || wrongEquals(equals);
    if (!assigns && kind(1) != TokenKind::Number) return false;
    const TextRange name{range(1).begin, range(equals - 1).end};
    if (!assigns) {
        error(Code::UnexpectedText, {word.begin, range(1).end}, "a Param needs a name before its value");
        for (advance(), advance(); !atEnd() && !newLine() && kind() == TokenKind::Unit;) advance();
        return true;
    }
    if (equals == 1) error(Code::ReservedWord, word, "a Param needs a name before its value: `Param name = ...`");
    else error(Code::UnexpectedText, name, "a name begins with a letter or _");
    const TextRange sign = range(equals);
    for (std::size_t i = 0; i <= equals; ++i) advance();
    if (!newLine() && !atEnd()) (void)m_grammar.value("Param", word, sign); // without a name it is no item
    return true;
}

std::optional<Name> ParamErrors::dollarName() {
    const bool braced = isBracedParam(text(1));
    if (text() != "Param" || newLine(1) || (kind(1) != TokenKind::ParamRef && !braced)) return {};
    const std::string_view written = text(1);
    Name meant{std::string(braced ? written.substr(2, written.size() - 3) : written.substr(1)), range(1)};
    if (!std::ranges::all_of(meant.text, isIdent)) return {};
    Diagnostic& d = error(Code::UnexpectedText, range(1), "the name of a Param is written without `$` where it gets its value");
    fix(d, meant.text, {edit(range(1), meant.text)});
    return meant;
}

bool ParamErrors::restOfName(Name& name) {
    const auto assigns = [this](std::size_t i) { return kind(i) == TokenKind::Equals || wrongEquals(i); };
    if (kind() == TokenKind::Word && !newLine() && !adjacent() && assigns(1)) {
        const TextRange both{name.range.begin, range().end};
        const std::string second(text());
        if (isType(name.text)) {
            Diagnostic& d = error(Code::UnexpectedText, name.range, "a Param has no type");
            fix(d, "remove `" + name.text + "`", {edit(both, second)});
        } else {
            Diagnostic& d = error(Code::UnexpectedText, both, "a name is one word");
            fix(d, name.text + "_" + second, {edit(both, name.text + "_" + second)});
        }
        name = this->name();
        advance();
        return true;
    }
    std::size_t pieces = 0;
    while (pieces < kMaxPieces && isPieceOfName(pieces)) ++pieces;
    if (pieces == 0 || !assigns(pieces)) return false;
    name.range.end = range(pieces - 1).end;
    name.text = slice(name.range);
    std::string joined = name.text;
    for (char& c : joined)
        if (!isIdent(c)) c = '_';
    Diagnostic& d = error(Code::UnexpectedText, name.range, "a name is letters, digits and _");
    fix(d, joined, {edit(name.range, joined)});
    for (; pieces > 0; --pieces) advance();
    return true;
}

bool ParamErrors::otherWord(std::vector<Item>& out, int depth) {
    const auto assigned = [this](std::size_t i) {
        return kind(i) == TokenKind::Word && !newLine(i) && (kind(i + 1) == TokenKind::Equals || wrongEquals(i + 1));
    };
    const bool two =
        (declares(text()) || isType(text())) && kind(1) == TokenKind::Word && !newLine(1) && isType(text(1)) && assigned(2);
    if (!two && !assigned(1)) return false;
    const TextRange words{range().begin, range(two ? 1 : 0).end};
    const std::string word(slice(words)), name(text(two ? 2 : 1));
    const bool isParam = declares(text()) || (isType(text()) && !isCapital(name));
    Diagnostic& d = error(Code::UnexpectedText, words,
                          "`" + word + "` does not belong before `" + name + " =`" +
                              (isParam ? "; a named value is written `Param " + name + " = ...`" : ""));
    if (isParam) {
        d.suggestions = {"Param"};
        fix(d, "Param", {edit(words, "Param")});
    }
    if (!isParam || isType(text())) fix(d, "remove `" + word + "`", {edit({words.begin, range(two ? 2 : 1).begin}, "")});
    if (two) advance();
    if (isParam) m_grammar.param(out, depth);
    else advance();
    return true;
}

} // namespace trundle
