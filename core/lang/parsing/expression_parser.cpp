#include "lang/parsing/expression_parser.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "base/spelling.h"
#include "base/units.h"
#include "base/utf8.h"
#include "lang/characters.h"

namespace trundle {
namespace {

struct Function {
    std::string_view name;
    std::size_t least, most;
};
constexpr std::array<Function, 16> kFunctions{{{"min", 2, 100},
                                               {"max", 2, 100},
                                               {"abs", 1, 1},
                                               {"sqrt", 1, 1},
                                               {"sin", 1, 1},
                                               {"cos", 1, 1},
                                               {"tan", 1, 1},
                                               {"asin", 1, 1},
                                               {"acos", 1, 1},
                                               {"atan2", 2, 2},
                                               {"floor", 1, 1},
                                               {"ceil", 1, 1},
                                               {"round", 1, 1},
                                               {"mod", 2, 2},
                                               {"if", 3, 3},
                                               {"element", 2, 2}}};

constexpr std::array<std::string_view, 6> kComparisons{"<=", ">=", "==", "!=", "<", ">"};
/// What counts towards the depth of a binary operator or call.
constexpr const char* kChains = ": nested parentheses and operators in a row; use Params for parts of it";

std::string countWords(const Function& f) {
    static constexpr const char* kWords[] = {"no", "one", "two", "three"};
    if (f.most > 3) return "two or more arguments";
    return std::string(kWords[f.most]) + (f.most == 1 ? " argument" : " arguments");
}

} // namespace

bool isFunction(std::string_view name) { return std::ranges::find(kFunctions, name, &Function::name) != kFunctions.end(); }

void ExpressionParser::element(Element& e, Value& v) {
    e.kind = Element::Kind::Expression;
    const std::size_t start = position();
    m_dollar = 0;
    advance();
    Sum inner = whole(1);
    if (inner.ok && kind() != TokenKind::CloseParen) {
        const bool over = atEnd() || newLine() || kind() == TokenKind::OpenBrace || kind() == TokenKind::CloseBrace ||
                          kind() == TokenKind::Comma || startsItem();
        if (m_foreign.list(start)) inner = failed();
        else if (over) inner = unclosed(m_tokens.at(start).range);
        else inner = fault(Code::BadExpression, range(), "operator or `)` expected");
    }
    if (!inner.ok) {
        skipToEnd(start);
        v.broken = true;
        inner.expression = {};
    }
    if (kind() == TokenKind::CloseParen) advance();
    e.range.end = previous().end;
    if (inner.ok) inner.expression.range = e.range;
    e.expression = std::make_shared<const Expression>(std::move(inner.expression));
}

ExpressionParser::Sum ExpressionParser::unclosed(TextRange open) {
    Sum none = fault(Code::BadExpression, open, "`$(` lacks its `)`");
    if (Diagnostic* d = m_report.lastAt(open); d && kind() != TokenKind::Comma)
        fix(*d, "add `)`", {edit({previous().end, previous().end}, ")")});
    return none;
}

/// Skips to the `)` of the expression that began at `start`, but not beyond its line, list or block.
void ExpressionParser::skipToEnd(std::size_t start) {
    int parens = 0;
    for (std::size_t i = start + 1; i < position(); ++i) {
        const TokenKind k = m_tokens.at(i).kind;
        parens += k == TokenKind::OpenParen ? 1 : k == TokenKind::CloseParen ? -1 : 0;
    }
    while (!atEnd() && !newLine() && kind() != TokenKind::OpenBrace && kind() != TokenKind::CloseBrace && !startsItem() &&
           kind() != TokenKind::Directive) {
        if (kind() == TokenKind::CloseParen && parens-- <= 0) break;
        if (kind() == TokenKind::OpenParen) ++parens;
        if (kind() == TokenKind::ExprOpen || kind() == TokenKind::String || kind() == TokenKind::ParamRef) {
            if (parens <= 0) break;
        }
        advance();
    }
}

ExpressionParser::Sum ExpressionParser::fault(Code code, TextRange r, std::string message) {
    error(code, r, std::move(message));
    return failed();
}

ExpressionParser::Sum ExpressionParser::failed() {
    Sum none;
    none.ok = false;
    return none;
}

ExpressionParser::Sum ExpressionParser::binary(Expression::Op op, Sum left, Sum right) {
    if (!left.ok) return left;
    if (!right.ok) return right;
    Sum both;
    both.height = std::max(left.height, right.height) + 1;
    both.expression.op = op;
    both.expression.range = {left.expression.range.begin, right.expression.range.end};
    if (both.height > kMaxExpressionDepth)
        return fault(Code::TooDeep, both.expression.range,
                     "this expression nests deeper than " + std::to_string(kMaxExpressionDepth) + kChains);
    both.expression.arguments.reserve(2);
    both.expression.arguments.push_back(std::move(left.expression));
    both.expression.arguments.push_back(std::move(right.expression));
    return both;
}

/// A comparison, with nothing behind it that other languages have there.
ExpressionParser::Sum ExpressionParser::whole(int depth) {
    Sum first = comparison(depth);
    return first.ok && m_foreign.behindOperand() ? failed() : first;
}

/// At most one: 1 for true, 0 for false.
ExpressionParser::Sum ExpressionParser::comparison(int depth) {
    Sum left = sum(depth);
    const bool single = kind() == TokenKind::Equals && !newLine();
    const bool compares = kind() == TokenKind::Unknown && std::ranges::find(kComparisons, text()) != kComparisons.end();
    if (!left.ok || (!single && !compares)) return left;
    const std::string op(single ? "==" : text());
    if (single) {
        Diagnostic& d = error(Code::BadExpression, range(), "a comparison is written `==`, not `=`");
        fix(d, "==", {edit(range(), "==")});
    }
    advance();
    Sum both = binary(Expression::Op::Call, std::move(left), sum(depth));
    both.expression.name = op;
    return both;
}

ExpressionParser::Sum ExpressionParser::sum(int depth) {
    if (depth > kMaxExpressionDepth)
        return fault(Code::TooDeep, range(), "expressions nest deeper than " + std::to_string(kMaxExpressionDepth));
    Sum left = product(depth);
    while (left.ok && (kind() == TokenKind::Plus || kind() == TokenKind::Minus)) {
        const auto op = kind() == TokenKind::Plus ? Expression::Op::Add : Expression::Op::Subtract;
        if (text() == kUnicodeMinus) unicodeMinus(range());
        advance();
        left = binary(op, std::move(left), product(depth));
    }
    return left;
}

ExpressionParser::Sum ExpressionParser::product(int depth) {
    Sum left = signedTerm(depth);
    while (left.ok && (kind() == TokenKind::Star || kind() == TokenKind::Slash)) {
        const auto op = kind() == TokenKind::Star ? Expression::Op::Multiply : Expression::Op::Divide;
        advance();
        left = binary(op, std::move(left), signedTerm(depth));
    }
    return left;
}

ExpressionParser::Sum ExpressionParser::signedTerm(int depth) {
    if (depth > kMaxExpressionDepth)
        return fault(Code::TooDeep, range(), "expressions nest deeper than " + std::to_string(kMaxExpressionDepth));
    if (m_foreign.beforeOperand()) return failed();
    if (kind() != TokenKind::Plus && kind() != TokenKind::Minus) return power(depth);
    const bool minus = kind() == TokenKind::Minus;
    const std::uint32_t begin = range().begin;
    if (text() == kUnicodeMinus) unicodeMinus(range());
    advance();
    Sum inner = signedTerm(depth + 1);
    if (!inner.ok || !minus) return inner;
    Sum negated;
    negated.height = inner.height + 1;
    negated.expression.op = Expression::Op::Negate;
    negated.expression.range = {begin, inner.expression.range.end};
    negated.expression.arguments.push_back(std::move(inner.expression));
    return negated;
}

/// 2^3^2 is 2^(3^2), -2^2 is -(2^2), 2^-1 is allowed.
ExpressionParser::Sum ExpressionParser::power(int depth) {
    Sum base = primary(depth);
    const bool stars = kind() == TokenKind::Star && kind(1) == TokenKind::Star && adjacent(1);
    if (!base.ok || (kind() != TokenKind::Caret && !stars)) return base;
    if (stars) {
        const TextRange both{range().begin, range(1).end};
        Diagnostic& d = error(Code::BadExpression, both, "a power is written `^`, not `**`");
        fix(d, "^", {edit(both, "^")});
        advance();
    }
    advance();
    return binary(Expression::Op::Power, std::move(base), signedTerm(depth + 1));
}

ExpressionParser::Sum ExpressionParser::primary(int depth) {
    Sum s;
    s.expression.range = range();
    switch (kind()) {
    case TokenKind::Number: return number();
    case TokenKind::Word:
        if (newLine() && startsItem()) return fault(Code::BadExpression, previous(), "a number or a name is missing here");
        if (kind(1) == TokenKind::OpenParen && !newLine(1)) return call(depth);
        s.expression.op = Expression::Op::Name;
        s.expression.name = text();
        advance();
        return s;
    case TokenKind::OpenParen: {
        advance();
        s = whole(depth + 1);
        if (!s.ok) return s;
        if (kind() != TokenKind::CloseParen)
            return fault(Code::BadExpression, newLine() || atEnd() ? previous() : range(), "`)` expected");
        advance();
        return s;
    }
    case TokenKind::ParamRef: {
        withDollar();
        s.expression.op = Expression::Op::Name;
        s.expression.name = text().substr(1);
        advance();
        return s;
    }
    case TokenKind::CloseParen: return fault(Code::BadExpression, range(), "a number or a name is missing before `)`");
    default:
        if (m_foreign.bracedParam()) {
            advance();
            return failed();
        }
        if (newLine() || atEnd() || kind() == TokenKind::CloseBrace || kind() == TokenKind::OpenBrace)
            return fault(Code::BadExpression, previous(), "a number or a name is missing here");
        return fault(Code::BadExpression, range(),
                     "a number or a name expected, not `" + std::string(text().substr(0, 20)) + "`");
    }
}

/// `$a` in an expression: one message for all of them in it, with a fix that repairs each.
void ExpressionParser::withDollar() {
    const std::string meant(text().substr(1));
    const TextEdit repaired = edit(range(), meant);
    if (m_dollar > 0) {
        Fix& each = m_report.at(m_dollar).fixes.back();
        each.title = "remove each `$`";
        return each.edits.push_back(repaired);
    }
    Diagnostic& d = error(Code::BadExpression, range(), "inside $( ) a Param is written without `$`");
    fix(d, meant, {repaired});
    m_dollar = m_report.indexOf(d);
}

ExpressionParser::Sum ExpressionParser::number() {
    Sum s;
    s.expression.range = range();
    const std::string_view digits = text();
    const auto [end, failure] = std::from_chars(digits.data(), digits.data() + digits.size(), s.expression.number);
    if (failure != std::errc() || end != digits.data() + digits.size())
        return fault(Code::BadNumber, range(), "`" + std::string(digits) + "` is no number, or out of range");
    advance();
    if (kind() == TokenKind::Unit && !m_foreign.isRemainder()) {
        const std::string meant = unitWithPower(text());
        s.expression.name = meant.empty() ? text() : meant;
        s.expression.range.end = range().end;
        if (!meant.empty()) {
            Diagnostic& d = error(Code::UnknownUnit, range(), "the unit `" + std::string(text()) + "` is written " + meant);
            fix(d, meant, {edit(range(), meant)});
        }
        advance();
        return s;
    }
    if (!m_foreign.isUnit()) return s;
    const TextRange unit = range();
    const std::string word(text());
    Sum none = fault(Code::UnknownUnit, unit, "there is no unit " + word);
    if (Diagnostic* d = m_report.lastAt(unit)) {
        d->suggestions = nearestWords(word, allUnitNames());
        for (const std::string& each : d->suggestions) fix(*d, each, {edit(unit, each)});
    }
    return none;
}

ExpressionParser::Sum ExpressionParser::call(int depth) {
    Sum s;
    s.expression.op = Expression::Op::Call;
    s.expression.name = text();
    const TextRange nameRange = range();
    s.expression.range = nameRange;
    const std::string functionName = s.expression.name;
    const auto function =
        std::find_if(kFunctions.begin(), kFunctions.end(), [&](const Function& f) { return f.name == functionName; });
    if (function == kFunctions.end()) {
        std::vector<std::string> names;
        for (const Function& f : kFunctions) names.emplace_back(f.name);
        m_foreign.unknownFunction(names);
        return failed();
    }
    advance();
    advance();
    int height = 0;
    while (kind() != TokenKind::CloseParen) {
        Sum argument = whole(depth + 1);
        if (!argument.ok) return argument;
        height = std::max(height, argument.height);
        s.expression.arguments.push_back(std::move(argument.expression));
        if (kind() == TokenKind::Comma) advance();
        else if (kind() != TokenKind::CloseParen)
            return fault(Code::BadExpression, newLine() || atEnd() ? previous() : range(), "`,` or `)` expected");
    }
    s.expression.range.end = range().end;
    advance();
    s.height = height + 1;
    const std::size_t count = s.expression.arguments.size();
    if (s.height > kMaxExpressionDepth)
        return fault(Code::TooDeep, s.expression.range,
                     "this expression nests deeper than " + std::to_string(kMaxExpressionDepth) + kChains);
    if (count < function->least || count > function->most)
        return fault(Code::BadExpression, s.expression.range, "`" + functionName + "` takes " + countWords(*function));
    return s;
}

} // namespace trundle
