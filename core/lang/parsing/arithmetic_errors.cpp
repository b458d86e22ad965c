#include "lang/parsing/arithmetic_errors.h"

#include <algorithm>

#include "lang/characters.h"
#include "lang/parsing/expression_parser.h"

namespace trundle {
namespace {

constexpr std::size_t kShort = 60; ///< characters of an expression that a fix repeats

/// `(x + 2)`, but not `(x) + (2)`.
bool isOneGroup(std::string_view text) {
    int depth = 0;
    for (std::size_t i = 0; i + 1 < text.size(); ++i) {
        depth += text[i] == '(' ? 1 : text[i] == ')' ? -1 : 0;
        if (depth == 0) return false;
    }
    return text.size() > 2 && text.back() == ')';
}

} // namespace

bool isOperator(TokenKind kind) {
    return kind == TokenKind::Plus || kind == TokenKind::Minus || kind == TokenKind::Star || kind == TokenKind::Slash ||
           kind == TokenKind::Caret;
}

bool isQuotient(std::string_view word) {
    const std::size_t sign = word.find('/');
    if (sign == std::string_view::npos || sign + 1 == word.size()) return word == "pi";
    return std::ranges::all_of(word.substr(0, sign), isIdent) &&
           std::ranges::all_of(word.substr(sign + 1), [](char c) { return isDigit(c) || c == '.'; });
}

bool ArithmeticErrors::wordAmongNumbers(Element& e, Value& v) {
    if (e.kind != Element::Kind::Word || !isQuotient(e.text) || isOperator(kind())) return false;
    const bool numberBefore = !v.elements.empty() && v.elements.back().kind == Element::Kind::Number;
    if (!numberBefore && !(kind() == TokenKind::Comma && kind(1) == TokenKind::Number)) return false;
    if (position() > 1 && isOperator(m_tokens.at(position() - 2).kind)) return false; // `-pi/2`, a sign before it
    arithmetic(e, v);
    if (Diagnostic* d = m_report.lastAt(e.range); d && e.text.starts_with("pi")) d->message += kDegrees;
    return true;
}

bool ArithmeticErrors::otherCall(Element& e, Value& v) {
    if (e.kind != Element::Kind::Word || kind() != TokenKind::OpenParen || !adjacent() || isFunction(e.text)) return false;
    constexpr std::size_t kFar = 60;
    std::size_t close = 1, commas = 0;
    bool plain = true; // numbers and Params alone
    for (; close < kFar && kind(close) != TokenKind::CloseParen; ++close) {
        const TokenKind k = kind(close);
        if (newLine(close) || k == TokenKind::OpenParen || k == TokenKind::OpenBrace || k == TokenKind::CloseBrace) return false;
        if (k == TokenKind::Comma) ++commas;
        else
            plain =
                plain && (k == TokenKind::Number || k == TokenKind::Unit || k == TokenKind::ParamRef || k == TokenKind::Minus);
    }
    if (close == kFar || close == 1 || isOperator(kind(close + 1))) return false;
    const std::string inside(slice({range(1).begin, range(close - 1).end}));
    for (std::size_t i = 0; i <= close; ++i) advance();
    e.range.end = previous().end;
    const bool isRange = e.text == "range", isCast = e.text == "int" || e.text == "float" || e.text == "double";
    const bool isRight = plain && (commas > 0 ? !isRange : isRange || isCast);
    Diagnostic& d = error(Code::BadExpression, e.range,
                          "there is no function `" + e.text + "`" +
                              (!isRight     ? std::string()
                               : commas > 0 ? "; a list is written without it: " + inside
                                            : "; the number is written alone: " + inside));
    if (isRight) fix(d, inside, {edit(e.range, inside)});
    e.kind = Element::Kind::Number;
    v.broken = true;
    return true;
}

/// `$if(a > b, x, y)`.
void ArithmeticErrors::calledParam(Element& e, Value& v) {
    v.broken = true;
    int open = 0;
    do {
        open += kind() == TokenKind::OpenParen || kind() == TokenKind::ExprOpen ? 1 : kind() == TokenKind::CloseParen ? -1 : 0;
        advance();
    } while (open > 0 && !newLine() && !atEnd());
    e.range.end = previous().end;
    std::string call(slice(e.range));
    std::erase(call, '$');
    Diagnostic& d = error(Code::UnexpectedText, e.range, "a function is written in $( ): `$(" + e.text + "(...))`");
    if (open == 0) fix(d, "$(" + call + ")", {edit(e.range, "$(" + call + ")")});
    e.kind = Element::Kind::Number;
}

/// `$n > 2`, `n > 2 ? 1 : 2` outside `$( )`.
bool ArithmeticErrors::comparison(Element& e, Value& v) {
    const bool compares = text() == "<" || text() == ">" || text() == "!" || text() == "?" || text() == "==";
    const bool orEqual = kind(1) == TokenKind::Equals && adjacent(1); // `>=`; `!` alone compares nothing
    if (kind() != TokenKind::Unknown || !compares || (text() == "!" && !orEqual) || newLine(orEqual ? 2 : 1)) return false;
    bool alternative = false;
    do {
        alternative = alternative || text() == "?";
        advance();
    } while (!atEnd() && !newLine() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace &&
             kind() != TokenKind::Comma && !startsItem());
    e.range.end = previous().end;
    Diagnostic& d =
        error(Code::BadExpression, e.range,
              alternative ? "one of two values is written $(if(condition, a, b))" : "a comparison is written in $( )");
    std::string inside(slice(e.range));
    std::erase_if(inside, [](char c) { return c == '$' || c == '{' || c == '}'; });
    if (!alternative && inside.size() < kShort) fix(d, "$(" + inside + ")", {edit(e.range, "$(" + inside + ")")});
    e.kind = Element::Kind::Number;
    e.unit.clear();
    v.broken = true;
    return true;
}

/// `$sizes[0]`.
bool ArithmeticErrors::elementOfList(Element& e, Value& v) {
    if (e.kind != Element::Kind::ParamRef || text() != "[" || !adjacent() || text(2) != "]") return false;
    const std::string meant = "$(element(" + e.text + ", " + std::string(text(1)) + "))";
    e.range.end = range(2).end;
    Diagnostic& d = error(Code::BadExpression, e.range, "an element of a list is written " + meant);
    fix(d, meant, {edit(e.range, meant)});
    for (int i = 0; i < 3; ++i) advance();
    v.broken = true;
    return true;
}

/// `2*0.05` or `1 - $x` outside `$( )`.
void ArithmeticErrors::arithmetic(Element& e, Value& v) {
    int parens = 0;
    bool units = !e.unit.empty();
    bool refs = e.kind == Element::Kind::ParamRef || e.kind == Element::Kind::Expression;
    bool operand = false; // after an operator, the next operand is part of the expression
    while (!atEnd() && !newLine()) {
        const TokenKind k = kind();
        if (isOperator(k)) operand = true;
        else if (k == TokenKind::OpenParen) ++parens, operand = true;
        else if (k == TokenKind::CloseParen && parens > 0) --parens, operand = parens > 0;
        else if (k == TokenKind::Unit) units = true;
        else if ((k == TokenKind::Number && (operand || adjacent())) ||
                 (operand && (k == TokenKind::ParamRef || k == TokenKind::ExprOpen || isBracedParam(text()) ||
                              (k == TokenKind::Word && !startsItem())))) {
            refs = refs || k == TokenKind::ParamRef || k == TokenKind::ExprOpen || k == TokenKind::Unknown;
            operand = parens > 0;
            if (k == TokenKind::ExprOpen) ++parens;
        } else if (!(parens > 0 && (k == TokenKind::Comma || k == TokenKind::Number || k == TokenKind::Word))) {
            break;
        }
        advance();
    }
    e.range.end = previous().end;
    Diagnostic& d = error(Code::BadExpression, e.range, "arithmetic is written in $( )");
    std::string inside(slice(e.range));
    if (refs) std::erase_if(inside, [](char c) { return c == '$' || c == '{' || c == '}'; });
    const std::string expression = isOneGroup(inside) ? "$" + inside : "$(" + inside + ")";
    if (!units && parens == 0 && inside.size() < kShort) fix(d, expression, {edit(e.range, expression)});
    e.kind = Element::Kind::Number;
    e.unit.clear();
    v.broken = true;
}

} // namespace trundle
