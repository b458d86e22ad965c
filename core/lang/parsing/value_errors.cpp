#include "lang/parsing/value_errors.h"

#include <algorithm>
#include <charconv>

#include "base/utf8.h"
#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxGaps = 1000; ///< bounds the size of a fix

/// `written`, which begins at offset `begin`, with a comma inserted in each gap.
std::string withCommas(std::string_view written, std::uint32_t begin, const std::vector<TextRange>& gaps) {
    std::string repaired(written);
    for (auto gap = gaps.rbegin(); gap != gaps.rend(); ++gap) repaired.replace(gap->begin - begin, gap->size(), ",");
    return repaired;
}

/// Of digits with a point at most.
bool isNumber(std::string_view text) {
    return !text.empty() && std::ranges::all_of(text, [](char c) { return isDigit(c) || c == '.'; }) &&
           std::ranges::count(text, '.') < 2;
}

/// A number with its unit in full-width characters, in plain ones: `1.5cm`; empty if it is none.
std::string numberIn(std::string_view written) {
    constexpr std::uint32_t kFirst = 0xFF01, kLast = 0xFF5E, kToAscii = 0xFEE0;
    std::string plain;
    bool wide = false;
    for (std::size_t at = 0; at < written.size();) {
        const CodePoint point = codePointAt(written, at);
        const bool isWide = point.valid && point.value >= kFirst && point.value <= kLast;
        if (!isWide && point.value >= 0x80) return {};
        plain += static_cast<char>(isWide ? point.value - kToAscii : point.value);
        wide = wide || isWide;
        at += point.length;
    }
    const std::size_t digits = plain.starts_with('-') ? 1 : 0;
    const std::size_t end = std::min(plain.find_first_not_of("0123456789.", digits), plain.size());
    const std::string_view number = std::string_view(plain).substr(digits, end - digits);
    const bool isUnit = std::ranges::all_of(std::string_view(plain).substr(end), isIdent);
    return wide && isUnit && isNumber(number) && std::ranges::any_of(number, isDigit) ? plain : std::string();
}

bool continuesText(TokenKind kind, std::string_view text) {
    switch (kind) {
    case TokenKind::End:
    case TokenKind::Comma:
    case TokenKind::OpenBrace:
    case TokenKind::CloseBrace:
    case TokenKind::String:
    case TokenKind::Directive: return false;
    case TokenKind::Unknown: return text != ";";
    default: return true;
    }
}

} // namespace

void ValueErrors::reportGaps(Value& v, const std::vector<TextRange>& gaps, std::string_view key) {
    v.broken = true;
    const bool semicolons = std::any_of(gaps.begin(), gaps.end(), [](TextRange gap) { return gap.size() > 0; });
    const bool words =
        !semicolons && std::ranges::all_of(v.elements, [](const Element& e) { return e.kind == Element::Kind::Word; });
    Diagnostic& d = error(Code::MissingComma, v.range,
                          words        ? "several words need double quotes or commas"
                          : semicolons ? "elements are separated by commas"
                                       : "a comma is missing between the elements");
    constexpr std::size_t kShort = 40;
    const std::string written(slice(v.range));
    const bool isText = key == "Title" || key == "Description" || key == "Help";
    const auto offerQuotes = [&] {
        if (!words || gaps.size() + 1 != v.elements.size()) return;
        fix(d, written.size() < kShort ? "\"" + written + "\"" : "put it in quotes", {edit(v.range, "\"" + written + "\"")});
    };
    if (gaps.size() > kMaxGaps || isText) return offerQuotes(); // a text is no list
    std::vector<TextEdit> edits;
    for (const TextRange gap : gaps) edits.push_back(edit(gap, ","));
    const std::string repaired = written.size() < kShort ? withCommas(written, v.range.begin, gaps) : std::string();
    fix(d, written.size() < kShort && repaired.find('\n') == std::string::npos ? repaired : "insert commas", std::move(edits));
    offerQuotes();
}

void ValueErrors::checkNumberTail(Element& e, Value& v) {
    const std::string_view digits = slice({e.range.begin, e.unitRange.begin});
    const bool hex = digits == "0" && e.unit.size() > 1 && (e.unit[0] == 'x' || e.unit[0] == 'X') &&
                     e.unit.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
    if (hex) {
        std::uint64_t number = 0;
        const auto [end, fault] = std::from_chars(e.unit.data() + 1, e.unit.data() + e.unit.size(), number, 16);
        Diagnostic& d = error(Code::BadNumber, e.range, "numbers are decimal, not hexadecimal");
        if (fault == std::errc()) fix(d, std::to_string(number), {edit(e.range, std::to_string(number))});
        (void)end;
    } else if (e.unit[0] == '_' && e.unit.find_first_not_of("0123456789_") == std::string::npos) {
        std::string joined(slice(e.range));
        std::erase(joined, '_');
        Diagnostic& d = error(Code::BadNumber, e.range, "a number has no `_` between its digits");
        fix(d, joined, {edit(e.range, joined)});
    } else if ((e.unit == "f" || e.unit == "F") && digits.find('.') != std::string_view::npos) {
        Diagnostic& d = error(Code::BadNumber, e.range, "a number has no `f` at its end");
        fix(d, std::string(digits), {edit(e.unitRange, "")});
    } else {
        return;
    }
    e.unit.clear();
    v.broken = true;
}

void ValueErrors::continuesAt(Element& e, Value& v) {
    if (m_arithmetic.wordAmongNumbers(e, v)) return;
    if (newLine() || atEnd()) return;
    const auto operandAt = [this](std::size_t i) {
        const TokenKind k = kind(i);
        return k == TokenKind::Number || k == TokenKind::ParamRef || k == TokenKind::ExprOpen || k == TokenKind::Word ||
               k == TokenKind::OpenParen || isBracedParam(text(i));
    };
    const bool number = e.kind == Element::Kind::Number;
    const bool word = e.kind == Element::Kind::Word;
    if (number && m_units.inPieces(e)) return;
    if (m_paths.computed(e, v) || m_paths.behindParam(e, v)) return;
    if (m_arithmetic.otherCall(e, v)) return;
    if (m_arithmetic.comparison(e, v) || m_arithmetic.elementOfList(e, v)) return;
    if (e.kind == Element::Kind::ParamRef && kind() == TokenKind::OpenParen && adjacent()) return m_arithmetic.calledParam(e, v);
    if (isOperator(kind()) && (number || e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression) &&
        operandAt(1))
        return arithmetic(e, v);
    if (!adjacent()) return;
    // Arithmetic with names is `b+1` or `a*2`; `a-1` and `a/b` may be texts.
    if (word && ((kind() == TokenKind::Star && operandAt(1)) || (text().starts_with('+') && !newLine()))) return arithmetic(e, v);
    if ((word && kind() == TokenKind::OpenParen) || (number && e.unit.empty() && kind() == TokenKind::Number))
        return arithmetic(e, v);
    if (!word && !number) return;
    if (word && text() == "[" && text(2) == "]" && kind(1) == TokenKind::Number && adjacent(1)) return unquotedText(e, v);
    const bool sign = kind() == TokenKind::Unknown && text() != ";" && text() != "]" && text() != "[";
    if (!sign && kind() != TokenKind::Dot && kind() != TokenKind::Slash && kind() != TokenKind::Star) return;
    if (!wrongEquals(0) || number || adjacent(1)) unquotedText(e, v);
}

/// Whether this is the bracket that closes what `bracket` opens.
bool ValueErrors::closes(TextRange bracket) const {
    return kind() == TokenKind::CloseParen || (kind() == TokenKind::Unknown && text() == "]") ||
           (slice(bracket) == "{" && kind() == TokenKind::CloseBrace);
}

/// Skips what follows the brackets of `(0,0,1)*2` and `(x,1),2`. True if it is nothing but more lists in brackets, `(q,p),(q,z)`; then
/// with the edits that remove these.
bool ValueErrors::skipRest(std::vector<TextEdit>& edits) {
    bool lists = true;
    while (!atEnd() && !newLine() && (isOperator(kind()) || kind() == TokenKind::Comma) && !newLine(1)) {
        lists = lists && kind() == TokenKind::Comma;
        advance();
        Value rest;
        const TextRange open = range();
        if (text() == "(" || text() == "[") {
            do advance();
            while (m_element(rest) && kind() == TokenKind::Comma);
            lists = lists && closes(open) && !rest.broken;
            edits.push_back(edit(open, ""));
            if (!closes(open)) break;
            edits.push_back(edit(range(), ""));
            advance();
        } else {
            lists = false;
            if (!m_element(rest)) break;
        }
    }
    return lists;
}

void ValueErrors::skipBrackets(TextRange bracket) {
    if (!closes(bracket)) return;
    advance();
    std::vector<TextEdit> none;
    (void)skipRest(none);
}

void ValueErrors::reportBrackets(Value& v, TextRange bracket, const std::vector<TextRange>& gaps) {
    const bool closed = closes(bracket);
    const TextRange whole{bracket.begin, closed ? range().end : std::max(bracket.end, v.range.end)};
    const std::size_t index = m_report.indexOf(error(Code::UnexpectedText, whole, "a list is written without brackets"));
    std::vector<TextEdit> edits{edit(bracket, "")};
    if (closed) edits.push_back(edit(range(), ""));
    constexpr std::uint32_t kShort = 40;
    std::string title = "remove the brackets";
    if (whole.size() < kShort && !v.elements.empty()) title = withCommas(slice(v.range), v.range.begin, gaps);
    if (gaps.size() < kMaxGaps)
        for (const TextRange gap : gaps) edits.push_back(edit(gap, ","));
    if (closed) advance();
    const bool lists = skipRest(edits), more = previous().end > whole.end;
    if (index > 0 && lists) fix(m_report.at(index), more ? "remove the brackets" : std::move(title), std::move(edits));
    v.range = whole; // a replacement of the value includes the brackets
}

void ValueErrors::signedElement(Element& e, Value& v) {
    const TextRange sign = range();
    const bool minus = kind() == TokenKind::Minus;
    const bool number = kind(1) == TokenKind::Number;
    advance();
    const TextRange operand = range();
    Value rest;
    if (!m_element(rest) || rest.elements.empty()) return;
    const Element& inner = rest.elements.back();
    e.range = {sign.begin, inner.range.end};
    v.broken = true;
    const std::string inside(slice(inner.range));
    if (number) {
        Diagnostic& d = error(Code::BadNumber, {sign.begin, operand.end}, "a sign is written directly before its number");
        const std::string joined = (minus ? "-" : "") + std::string(slice(operand));
        if (slice(operand)[0] != '-' && slice(operand)[0] != '+') fix(d, joined, {edit({sign.begin, operand.end}, joined)});
        e.kind = Element::Kind::Number;
        e.number = minus ? -inner.number : inner.number;
        e.unit = inner.unit;
        e.unitRange = inner.unitRange;
        return;
    }
    if (inner.kind == Element::Kind::ParamRef || inner.kind == Element::Kind::Expression) {
        const bool param = inner.kind == Element::Kind::ParamRef;
        const std::string inParens = param ? "$(-" + inner.text + ")" : "$(-" + inside.substr(1) + ")";
        Diagnostic& d = error(Code::BadExpression, e.range, "a sign before a Param is written in $( )");
        fix(d, minus ? inParens : inside, {edit(e.range, minus ? inParens : inside)});
        e.kind = Element::Kind::ParamRef;
        e.text = param ? inner.text : std::string();
        if (!param) {
            e.kind = Element::Kind::Expression;
            e.expression = inner.expression;
        }
        return;
    }
    if (isQuotient(inside)) {
        const std::string meant = std::string(minus ? "$(-" : "$(") + inside + ")";
        Diagnostic& d = error(Code::BadExpression, e.range,
                              std::string("arithmetic is written in $( )") + (inside.starts_with("pi") ? kDegrees : ""));
        fix(d, meant, {edit(e.range, meant)});
        e.kind = Element::Kind::Number;
        return;
    }
    const bool infinite =
        inside == "inf" || inside == "infinity" || inside == "Infinity" || inside == "INF" || inside == "nan" || inside == "NaN";
    error(infinite ? Code::BadNumber : Code::UnexpectedText, e.range, infinite ? "numbers are finite" : "a word has no sign");
    e.text = inside;
}

void ValueErrors::foreignQuotes(Element& e, Value& v) {
    const std::string_view written = text();
    const std::uint32_t open = codePointAt(written, 0).length;
    std::uint32_t close = 1;
    while (close < written.size() && (static_cast<unsigned char>(written[written.size() - close]) & 0xC0) == 0x80) ++close;
    e.kind = Element::Kind::String;
    e.text = written.substr(open, written.size() - open - close);
    Diagnostic& d = error(Code::UnexpectedText, e.range, "text is written in double quotes \"...\"");
    if (e.text.find_first_of("\"\\") == std::string::npos) fix(d, "\"" + e.text + "\"", {edit(e.range, "\"" + e.text + "\"")});
    v.broken = true;
    advance();
}

void ValueErrors::bracedParam(Element& e, Value& v) {
    std::string inner(text().substr(2, text().size() - 3));
    std::erase(inner, '$');
    while (isBlank(inner.front())) inner.erase(0, 1);
    while (isBlank(inner.back())) inner.pop_back();
    advance();
    v.broken = true;
    e.kind = Element::Kind::ParamRef;
    e.text = inner;
    if (isOperator(kind()) && !newLine() && !newLine(1)) return arithmetic(e, v);
    const auto isPart = [this] {
        return adjacent() &&
               (kind() == TokenKind::Word || kind() == TokenKind::Number || kind() == TokenKind::Dot || isBracedParam(text()));
    };
    const bool isPartOfWord = isPart();
    while (isPart()) advance();
    e.range.end = previous().end;
    if (isPartOfWord) return void(error(Code::UnexpectedText, e.range, "a Param is written $name, and cannot be part of a word"));
    const bool isName = isIdentStart(inner[0]) && std::ranges::all_of(inner, isIdent);
    const std::string meant = isName ? "$" + inner : "$(" + inner + ")";
    Diagnostic& d = error(Code::UnexpectedText, e.range,
                          isName ? "a Param is written `$" + inner + "` or `$(" + inner + ")`, without braces"
                                 : "an expression is written `$(...)`, without braces");
    fix(d, meant, {edit(e.range, meant)});
    if (!isName) e.kind = Element::Kind::Number;
}

void ValueErrors::doubleBraces(Element& e, Value& v) {
    while (!atEnd() && kind() != TokenKind::CloseBrace) {
        advance();
        if (newLine()) break;
    }
    const bool closed = kind() == TokenKind::CloseBrace && kind(1) == TokenKind::CloseBrace && adjacent(1);
    e.kind = Element::Kind::ParamRef;
    e.text = slice({e.range.begin + 2, previous().end});
    while (!e.text.empty() && isBlank(e.text.front())) e.text.erase(0, 1);
    for (int i = 0; i < 2 && !newLine() && kind() == TokenKind::CloseBrace; ++i) advance();
    while (adjacent() && kind() == TokenKind::Word) advance(); // `{{side}}_wheel`
    const bool part = closed && bytes()[previous().end - 1] != '}';
    e.range.end = previous().end;
    const bool isName = !e.text.empty() && isIdentStart(e.text[0]) && std::ranges::all_of(e.text, isIdent);
    const std::string meant = isName ? "$" + e.text : "$(" + e.text + ")";
    Diagnostic& d = error(Code::UnexpectedText, e.range,
                          part     ? "a Param is written $name, and cannot be part of a word"
                          : isName ? "a Param is written `" + meant + "`, without braces"
                                   : "an expression is written `$(...)`, without braces");
    if (closed && !part) fix(d, meant, {edit(e.range, meant)});
    if (!isName) e.kind = Element::Kind::Number;
    v.broken = true;
}

void ValueErrors::spacedParam(Element& e, Value& v) {
    advance();
    e.kind = Element::Kind::ParamRef;
    e.text = text();
    e.range.end = range().end;
    advance();
    Diagnostic& d = error(Code::UnexpectedText, e.range, "a Param is written `$" + e.text + "`, without a space");
    fix(d, "$" + e.text, {edit(e.range, "$" + e.text)});
    v.broken = true;
}

void ValueErrors::unquotedText(Element& e, Value& v) {
    const bool begun =
        e.range.end <= previous().end && position() > 0 && previous().end >= e.range.end && e.range.begin < range().begin;
    if (!begun) advance();
    while (adjacent() && continuesText(kind(), text())) advance();
    e.range.end = previous().end;
    const std::string_view bytes = this->bytes();
    if (bytes[e.range.end - 1] == ':' && bytes.substr(e.range.end, 2) == "//") { // `//` of a URL, lexed as a comment
        while (e.range.end < bytes.size() && !isBlank(bytes[e.range.end]) && bytes[e.range.end] != '\n' &&
               bytes[e.range.end] != '\r')
            ++e.range.end;
    }
    const std::string written(slice(e.range));
    v.broken = true;
    reportUnquoted(e, written);
    e.kind = Element::Kind::String;
    e.text = written;
    e.unit.clear();
}

void ValueErrors::reportUnquoted(const Element& e, const std::string& written) {
    if (written.starts_with("\xE2\x80\x93") && written.size() > 3 && (isDigit(written[3]) || written[3] == '.')) { // en dash
        const TextRange dash{e.range.begin, e.range.begin + 3};
        Diagnostic& d = error(Code::BadNumber, dash, "a dash U+2013 instead of a minus");
        fix(d, "-", {edit(dash, "-")});
    } else if (const std::size_t colon = written.find(':');
               colon != std::string::npos && isNumber(written.substr(0, colon)) && isNumber(written.substr(colon + 1))) {
        const std::string meant = "$(" + written.substr(0, colon) + "/" + written.substr(colon + 1) + ")";
        Diagnostic& d = error(Code::BadExpression, e.range, "a ratio is written as a number or in $( )");
        fix(d, meant, {edit(e.range, meant)});
    } else if (const std::string number = numberIn(written); !number.empty()) {
        Diagnostic& d = error(Code::BadNumber, e.range, "full-width characters; a number is written `" + number + "`");
        fix(d, number, {edit(e.range, number)});
    } else if (m_paths.element(e, written)) {
        return;
    } else if (written.size() > 1 && written[0] == '$' && isDigit(written[1])) {
        error(Code::UnexpectedText, e.range,
              "behind `$` is the name of a Param, which begins with a letter; a text with `$` is written in double quotes");
    } else if (written == "$" || std::count(written.begin(), written.end(), '"') > 0) {
        error(Code::UnexpectedText, e.range, "syntax error: unexpected `" + written + "`");
    } else {
        Diagnostic& d =
            error(Code::UnexpectedText, e.range,
                  written[0] == '#' ? "a value has no `#`; a text is written in double quotes, a colour as r,g,b from 0 to 1"
                                    : "this text needs double quotes");
        std::string quoted = "\"";
        for (const char c : written) quoted += c == '\\' ? std::string("\\\\") : std::string(1, c);
        quoted += '"';
        if (written[0] != '#') fix(d, quoted, {edit(e.range, quoted)});
    }
}

} // namespace trundle
