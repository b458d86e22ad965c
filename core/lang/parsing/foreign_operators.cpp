#include "lang/parsing/foreign_operators.h"

#include <algorithm>
#include <array>

#include "base/spelling.h"
#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::size_t kFar = 200; ///< tokens; how far ahead a `)` is looked for
constexpr const char* kAlternative = "one of two values is written if(condition, a, b)";

} // namespace

bool ForeignOperators::report(TextRange place, std::string message) {
    error(Code::BadExpression, place, std::move(message));
    return true;
}

bool ForeignOperators::startsOperand(std::size_t ahead) const {
    if (newLine(ahead)) return false;
    switch (kind(ahead)) {
    case TokenKind::Number:
    case TokenKind::Word:
    case TokenKind::OpenParen:
    case TokenKind::ParamRef: return true;
    default: return false;
    }
}

/// How many tokens `&&`, `||`, `and` or `or` is; 0: none is here.
std::size_t ForeignOperators::logicalTokens() const {
    if (newLine()) return 0;
    if (kind() == TokenKind::Word) return (text() == "and" || text() == "or") && startsOperand(1) ? 1 : 0;
    if (kind() != TokenKind::Unknown || (text() != "&" && text() != "|")) return 0;
    return text(1) == text() && adjacent(1) ? 2 : 1;
}

bool ForeignOperators::behindOperand() {
    if (const std::size_t count = logicalTokens(); count > 0) {
        const TextRange place{range().begin, range(count - 1).end};
        const bool isAnd = text() == "&" || text() == "and";
        return report(place, "there is no `" + std::string(slice(place)) +
                                 (isAnd ? "`; that both are so is written if(a, b, 0)"
                                        : "`; that one of them is so is written if(a, 1, b)"));
    }
    if (kind() == TokenKind::Unknown && text() == "?") return report(range(), std::string(kAlternative) + ", not with `?`");
    if (kind() == TokenKind::Word && text() == "if" && !newLine()) return report(range(), kAlternative);
    if (isRemainder()) return report(range(), "a remainder is written mod(a, b)");
    if (text() == "[" && adjacent() && text(2) == "]") {
        const std::string list(slice(previous())), index(text(1));
        return report({range().begin, range(2).end}, "an element of a list is written element(" + list + ", " + index + ")");
    }
    const std::size_t axis = kind() == TokenKind::Dot && adjacent() && adjacent(1) ? std::string_view("xyz").find(text(1)) : 3;
    if (axis < 3 && text(1).size() == 1)
        return report({range().begin, range(1).end}, "an element of a list is written element(" + std::string(slice(previous())) +
                                                         ", " + std::to_string(axis) + ")");
    if (text() != "//") return false;
    return report(range(), "`//` begins a comment: a quotient is written a/b, without its fraction floor(a/b)");
}

bool ForeignOperators::beforeOperand() {
    if (!startsOperand(1)) return false;
    if (kind() == TokenKind::Word && text() == "if" && kind(1) != TokenKind::OpenParen) return report(range(), kAlternative);
    if (!(kind() == TokenKind::Unknown && text() == "!") && !(kind() == TokenKind::Word && text() == "not")) return false;
    return report(range(), "there is no `" + std::string(text()) + "`; that something is not so is written if(a, 0, 1)");
}

bool ForeignOperators::isRemainder() const {
    if (newLine() || !startsOperand(1) || startsItem() || startsItem(1)) return false;
    return (text() == "%" && (kind() == TokenKind::Unknown || kind() == TokenKind::Unit)) ||
           (text() == "mod" && kind() == TokenKind::Word && kind(1) != TokenKind::OpenParen);
}

bool ForeignOperators::isUnit() const {
    if (kind() != TokenKind::Word || newLine() || startsItem() || text() == "if" || isRemainder() || logicalTokens() > 0)
        return false;
    return adjacent() || kind(1) != TokenKind::OpenParen; // else an operator is missing before a function
}

bool ForeignOperators::bracedParam() {
    if (!isBracedParam(text())) return false;
    std::string inner(text().substr(2, text().size() - 3));
    std::erase(inner, '$');
    while (!inner.empty() && isBlank(inner.front())) inner.erase(0, 1);
    while (!inner.empty() && isBlank(inner.back())) inner.pop_back();
    bool isName = !inner.empty() && isIdentStart(inner[0]);
    for (const char c : inner) isName = isName && isIdent(c);
    const std::string meant = isName ? inner : "(" + inner + ")";
    const TextRange place = range();
    Diagnostic& d = error(Code::BadExpression, place, "inside $( ) a Param is written without `$` and braces");
    fix(d, meant, {edit(place, meant)});
    return true;
}

/// How many tokens ahead the `)` of the expression is, on this line; 0: it is not there.
std::size_t ForeignOperators::closeAhead() const {
    int parens = 0;
    for (std::size_t i = 0; i < kFar && !newLine(i); ++i) {
        switch (kind(i)) {
        case TokenKind::OpenParen: ++parens; break;
        case TokenKind::CloseParen:
            if (parens-- == 0) return i;
            break;
        case TokenKind::End:
        case TokenKind::Equals:
        case TokenKind::ExprOpen:
        case TokenKind::OpenBrace:
        case TokenKind::CloseBrace: return 0;
        default: break;
        }
    }
    return 0;
}

bool ForeignOperators::list(std::size_t start) {
    const std::size_t ahead = closeAhead();
    if (kind() != TokenKind::Comma || ahead == 0) return false;
    const std::size_t close = position() + ahead;
    std::string meant;
    int parens = 0;
    std::size_t first = start + 1; // of the element
    for (std::size_t i = first; i <= close; ++i) {
        const TokenKind k = m_tokens.at(i).kind;
        if (!(parens == 0 && (k == TokenKind::Comma || i == close))) {
            parens += k == TokenKind::OpenParen ? 1 : k == TokenKind::CloseParen ? -1 : 0;
            continue;
        }
        if (i == first) return report(m_tokens.at(i).range, "a number or a name is missing here");
        const std::string part(slice({m_tokens.at(first).range.begin, m_tokens.at(i - 1).range.end}));
        bool isNumber = true;
        for (std::size_t j = first; j < i; ++j) {
            const TokenKind each = m_tokens.at(j).kind;
            isNumber =
                isNumber && (each == TokenKind::Number || each == TokenKind::Unit || (each == TokenKind::Minus && j == first));
        }
        meant += (meant.empty() ? "" : ",") + (isNumber ? part : "$(" + part + ")");
        first = i + 1;
    }
    constexpr std::size_t kShort = 40;
    const TextRange all{m_tokens.at(start).range.begin, m_tokens.at(close).range.end};
    Diagnostic& d = error(Code::BadExpression, all,
                          "$( ) gives one number; a list is written " + (meant.size() < kShort ? meant : "$(a),$(b),$(c)"));
    fix(d, meant.size() < kShort ? meant : "one $( ) for each element", {edit(all, meant)});
    return true;
}

void ForeignOperators::unknownFunction(const std::vector<std::string>& known) {
    struct Foreign {
        std::string_view name, message;
    };
    constexpr std::array<Foreign, 3> kForeign{{{"atan", "an angle from its tangent y/x is atan2(y, x)"},
                                               {"pow", "a power is written x^y"},
                                               {"fmod", "a remainder is written mod(a, b)"}}};
    const std::string name(text());
    const TextRange place = range();
    std::string message = "there is no function `" + name + "`; ";
    std::string all = "there are";
    for (const std::string& each : known) all += " " + each;
    const auto* foreign = std::find_if(kForeign.begin(), kForeign.end(), [&](const Foreign& f) { return f.name == name; });
    const bool isForeign = foreign != kForeign.end();
    message += isForeign ? std::string(foreign->message) : all;
    report(place, std::move(message));
    Diagnostic* d = m_report.lastAt(place);
    if (!d) return;
    if (isForeign) {
        d->suggestions = {name == "atan" ? "atan2" : name == "fmod" ? "mod" : "^"};
        if (name == "fmod") fix(*d, "mod", {edit(place, "mod")});
        return;
    }
    d->suggestions = nearestWords(name, known);
    if (!d->suggestions.empty()) fix(*d, d->suggestions[0], {edit(place, d->suggestions[0])});
    return;
}

} // namespace trundle
