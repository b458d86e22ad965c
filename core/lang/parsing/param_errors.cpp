#include "lang/parsing/param_errors.h"

#include <algorithm>
#include <array>

#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxPieces = 20; ///< tokens of a name with signs

bool declares(std::string_view word) {
    constexpr std::array<std::string_view, 9> kWords{"param",     "PARAM", "var", "let",  "const",
                                                     "constexpr", "auto",  "def", "local"};
    return std::ranges::find(kWords, word) != kWords.end();
}

bool isDescription(std::string_view key) { return key == "Min" || key == "Max" || key == "Choices" || key == "Help"; }

} // namespace

bool ParamErrors::isType(std::string_view word) {
    constexpr std::array<std::string_view, 9> kTypes{"bool",   "double", "float",  "int",     "long",
                                                     "number", "real",   "string", "unsigned"};
    return std::ranges::find(kTypes, word) != kTypes.end();
}

Item ParamErrors::unknown(const Name& name) {
    ParamItem item;
    item.name = name;
    item.value.range = {name.range.end, name.range.end};
    item.value.broken = true;
    return {name.range, std::move(item)};
}

/// `Param r { Value=3 }`, `Param r = { Value=3 }`, `Param { Name=r Value=3 }`.
bool ParamErrors::blockForm(std::vector<Item>& out) {
    const bool named = kind(1) == TokenKind::Word;
    const std::size_t first = named ? 2 : 1, brace = named && kind(2) == TokenKind::Equals ? 3 : first;
    if (kind(brace) != TokenKind::OpenBrace || newLine(brace)) return false;
    if (brace == 3 && (kind(4) != TokenKind::Word || kind(5) != TokenKind::Equals)) return false; // `Param v = {1,2}`
    Name own = name(1);
    Diagnostic& d = error(Code::UnexpectedText, named ? own.range : range(), {});
    const std::size_t fault = m_report.indexOf(d);
    for (std::size_t i = 0; i <= brace; ++i) advance();
    std::string value = "value";
    for (int open = 1; !atEnd() && open > 0; advance()) {
        open += kind() == TokenKind::OpenBrace ? 1 : kind() == TokenKind::CloseBrace ? -1 : 0;
        if (kind(1) != TokenKind::Equals || open != 1) continue;
        const bool isName = text() == "Name" || text() == "name",
                   isValue = text() == "Value" || text() == "Default" || text() == "value";
        if (isName && !named && kind(2) == TokenKind::Word) own = name(2);
        if (isValue && kind(2) != TokenKind::End) value = text(2);
    }
    const bool known = named || own.text != "{";
    if (fault > 0)
        m_report.at(fault).message = "a Param has its value before its { }: `Param " + (known ? own.text : "name") + " = " +
                                     value + " { Min=... Help=... }`";
    if (known) out.push_back(unknown(own));
    return true;
}

bool ParamErrors::otherForm(std::vector<Item>& out) {
    if (text() != "Param" || newLine(1)) return false;
    if (blockForm(out)) return true;
    const bool quoted = kind(1) == TokenKind::String && kind(2) == TokenKind::Equals;
    const std::size_t paren = kind(1) == TokenKind::Word ? 2 : 1; // `Param r(3)`, `Param(r, 3)`
    if (!quoted && (kind(paren) != TokenKind::OpenParen || newLine(paren))) return false;
    Name own = name(quoted || paren == 2 ? 1 : 2);
    if (quoted) own.text = own.text.substr(1, own.text.size() - 2);
    if (own.text.empty() || !isIdentStart(own.text[0]) || !std::ranges::all_of(own.text, isIdent)) return false;
    const std::uint32_t begin = range().begin;
    do advance();
    while (!atEnd() && !newLine() && kind() != TokenKind::CloseBrace && kind() != TokenKind::OpenBrace);
    error(Code::UnexpectedText, {begin, previous().end}, "a Param is written `Param " + own.text + " = value`");
    out.push_back(unknown(own));
    return true;
}

void ParamErrors::looseDescription(ParamItem& param) {
    const auto begins = [this] {
        return !newLine() && kind() == TokenKind::Word && isDescription(text()) && kind(1) == TokenKind::Equals;
    };
    if (!begins()) return;
    const TextRange before = previous();
    Diagnostic& d = error(Code::UnexpectedText, range(), "what is said about a Param is in { } behind its value");
    const std::size_t fault = m_report.indexOf(d);
    param.open = {before.end, before.end};
    const std::size_t outer = m_report.joinSeparators(fault);
    if (fault > 0) fix(m_report.at(fault), "{ }", {edit({before.end, range().begin}, " { ")});
    while (begins()) {
        AssignmentItem item;
        item.path.push_back(name());
        item.pathRange = range();
        const TextRange equals = range(1);
        const std::string key(text());
        advance();
        advance();
        item.value = m_grammar.value(key, item.pathRange, equals);
        param.items.push_back({{item.pathRange.begin, previous().end}, std::move(item)});
    }
    m_report.joinSeparators(outer);
    param.close = {previous().end, previous().end};
    if (fault > 0) m_report.at(fault).fixes.back().edits.push_back(edit(param.close, " }"));
}

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
    if (text() == ":" && isType(text(1)) && kind(2) == TokenKind::Equals && !newLine(1)) { // `Param r: float = 1`
        const TextRange all{range().begin, range(1).end};
        Diagnostic& d = error(Code::UnexpectedText, all, "a Param has no type");
        fix(d, "remove `" + std::string(slice(all)) + "`", {edit(all, "")});
        advance();
        advance();
        return true;
    }
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

bool ParamErrors::limitsInBrackets() {
    const auto numberAt = [this](std::size_t i) { return i + (kind(i) == TokenKind::Minus && kind(i + 1) == TokenKind::Number); };
    const auto endOf = [this](std::size_t number) { return number + (kind(number + 1) == TokenKind::Unit); };
    const std::size_t low = numberAt(1), comma = endOf(low) + 1, high = numberAt(comma + 1), close = endOf(high) + 1;
    if (kind(low) != TokenKind::Number || kind(comma) != TokenKind::Comma || kind(high) != TokenKind::Number) return false;
    if (kind(close) != TokenKind::CloseParen && text(close) != "]") return false;
    const TextRange all{range().begin, range(close).end};
    const std::string limits = "{ Min=" + std::string(slice({range(1).begin, range(comma - 1).end})) +
                               " Max=" + std::string(slice({range(comma + 1).begin, range(close - 1).end})) + " }";
    Diagnostic& d = error(Code::UnexpectedText, all, "the limits of a Param are written `" + limits + "`");
    fix(d, limits, {edit(all, limits)});
    for (std::size_t i = 0; i <= close; ++i) advance();
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
