#include "lang/lexer.h"

#include <algorithm>

#include "base/units.h"
#include "base/utf8.h"

namespace trundle {

std::vector<Token> Lexer::lex() {
    if (m_text.starts_with(kBom)) emit(TokenKind::Bom, kBom.size());
    while (m_at < m_text.size()) next();
    emit(TokenKind::End, m_at);
    return std::move(m_tokens);
}

void Lexer::lexSome(std::vector<Token>& out, std::size_t most) {
    m_tokens = std::move(out);
    const std::size_t enough = m_tokens.size() + most;
    if (m_at == 0 && m_text.starts_with(kBom)) emit(TokenKind::Bom, kBom.size());
    while (m_at < m_text.size() && m_tokens.size() < enough) next();
    out = std::move(m_tokens);
}

void Lexer::emit(TokenKind kind, std::size_t end) {
    m_tokens.push_back({kind, {static_cast<std::uint32_t>(m_at), static_cast<std::uint32_t>(end)}});
    m_at = end;
    if (isTrivia(kind)) return void(++m_trivia);
    m_trivia = 0;
    m_last = kind;
    m_firstOnLine = false;
}

void Lexer::next() {
    if (trivia()) return;
    const char c = m_scan.at(m_at);
    if (const std::size_t end = m_scan.numberEnd(m_at, m_parens == 0); end > m_at) return number(end);
    if (m_scan.wordStartsAt(m_at)) return word();
    if (c == '"') return string();
    if (c == '$') return dollar();
    if (c == '#') return hash();
    punctuation();
}

bool Lexer::trivia() {
    if (m_trivia >= kMaxTrivia)
        if (const std::size_t end = m_scan.commentsEnd(m_at); end > m_at) return emit(TokenKind::LineComment, end), true;
    const char c = m_scan.at(m_at);
    if (isBlank(c)) return emit(TokenKind::Space, m_scan.skipBlanks(m_at)), true;
    if (c == '\n' || c == '\r') {
        if (m_parens > 0) expressionLineEnd();
        m_firstOnLine = true;
        m_sameLine = false;
        emit(TokenKind::LineEnd, m_scan.afterLineEnd(m_at));
        if (const std::size_t end = m_scan.blankLinesEnd(m_at); end > m_at) emit(TokenKind::LineEnd, end);
        return true;
    }
    if (isQuotient()) return emit(TokenKind::Unknown, m_at + 2), true;
    if (!m_scan.commentAt(m_at)) return false;
    if (m_scan.at(m_at + 1) == '/') return emit(TokenKind::LineComment, m_scan.lineEnd(m_at)), true;
    const std::size_t close = m_text.find("*/", m_at + 2);
    return emit(TokenKind::BlockComment, close == std::string_view::npos ? m_text.size() : close + 2), true;
}

/// Whether an operand of an expression belongs behind its last token.
bool Lexer::operandFollows() const {
    switch (m_last) {
    case TokenKind::Plus:
    case TokenKind::Minus:
    case TokenKind::Star:
    case TokenKind::Slash:
    case TokenKind::Caret:
    case TokenKind::Comma:
    case TokenKind::OpenParen:
    case TokenKind::ExprOpen: return m_parens > 0;
    default: return false;
    }
}

/// `$(a // 2)`: no comment, since the `)` is in it and the expression does not continue on the next line.
bool Lexer::isQuotient() const {
    if (m_parens == 0 || m_firstOnLine || !operandPrecedes() || !m_scan.startsWith(m_at, "//")) return false;
    const std::size_t end = m_scan.lineEnd(m_at);
    if (m_text.substr(m_at, end - m_at).find(')') == std::string_view::npos) return false;
    const char c = m_scan.at(m_scan.skipTrivia(end));
    return c == '\0' || std::string_view("+-*/^,)").find(c) == std::string_view::npos;
}

// An expression continues after a line end only at an operator, so a missing `)` affects one line, not the rest of the file.
void Lexer::expressionLineEnd() {
    if (operandFollows()) return;
    if (m_at < m_continuedAt) return; // found at an earlier line end; avoids quadratic time
    m_continuedAt = m_scan.skipTrivia(m_at);
    const char c = m_scan.at(m_continuedAt);
    if (c == '\0' || std::string_view("+-*/^,)").find(c) == std::string_view::npos) m_parens = 0;
}

void Lexer::number(std::size_t end) {
    emit(TokenKind::Number, end);
    if (m_parens > 0) return unitInExpression();
    m_state = LexerState::AfterElement;
    m_sameLine = m_numbers = true;
    if (const std::size_t wide = m_scan.invisibleAt(m_at); wide > 0 && m_scan.unitEnd(m_at + wide) > m_at + wide)
        emit(TokenKind::Unknown, m_at + wide);
    const std::size_t unit = m_scan.skipBlanks(m_at);
    const std::size_t unitStop = m_scan.unitEnd(unit);
    if (unitStop == unit) return;
    if (unit > m_at) emit(TokenKind::Space, unit);
    emit(TokenKind::Unit, unitStop);
}

/// Only a unit that there is: `2 x` may be a forgotten operator.
void Lexer::unitInExpression() {
    const std::size_t unit = m_scan.skipBlanks(m_at);
    const std::size_t stop = m_scan.unitEnd(unit);
    const std::string_view written = m_text.substr(unit, stop - unit);
    if (stop == unit || (!findUnit(written) && unitWithPower(written).empty())) return;
    if (unit > m_at) emit(TokenKind::Space, unit);
    emit(TokenKind::Unit, stop);
}

/// `1,2,` or `X =` followed by `Box b {` on the next line: an element is missing, and Box is not that element.
bool Lexer::blockMayFollow() const {
    return !m_sameLine && (m_last == TokenKind::Equals || (m_numbers && m_last == TokenKind::Comma));
}

void Lexer::word() {
    const std::size_t ident = m_scan.identEnd(m_at);
    // Looking ahead from every component of one long path would take quadratic time.
    const bool insidePath = m_last == TokenKind::Dot;
    if (m_parens > 0 || insidePath) return emit(TokenKind::Word, ident);
    if (const std::size_t end = m_scan.otherPathEnd(m_at); end > m_at) {
        m_state = LexerState::Structure;
        return emit(TokenKind::Word, end);
    }
    if (m_state == LexerState::Structure) return emit(TokenKind::Word, ident);
    const bool key = m_scan.isKeyOrKind(m_at, ident);
    if (m_state == LexerState::Value && !key && !(blockMayFollow() && m_scan.isNamedBlock(ident))) {
        emit(TokenKind::Word, m_scan.wordEnd(m_at));
        m_state = LexerState::AfterElement;
        m_sameLine = true;
        m_numbers = false;
        return;
    }
    // `a b.c` in a value: the comma is missing.
    if (m_state == LexerState::AfterElement && m_sameLine && !key && !m_scan.isNamedBlock(ident))
        return emit(TokenKind::Word, m_scan.wordEnd(m_at));
    m_state = LexerState::Structure;
    emit(TokenKind::Word, ident);
}

void Lexer::string() {
    std::size_t i = m_at + 1;
    const auto inLine = [this](std::size_t k) { return k < m_text.size() && m_text[k] != '\n' && m_text[k] != '\r'; };
    while (inLine(i) && m_text[i] != '"') i += m_text[i] == '\\' && inLine(i + 1) ? 2 : 1;
    emit(TokenKind::String, m_scan.at(i) == '"' ? i + 1 : beforeBraces(i));
    m_parens = 0;
    m_state = LexerState::AfterElement;
    m_sameLine = true;
    m_numbers = false;
}

/// Where a string that is not closed in its line ends: before the `}` at the end of the line, which close blocks.
std::size_t Lexer::beforeBraces(std::size_t lineEnd) const {
    const std::string_view line = m_text.substr(m_at, lineEnd - m_at);
    const auto trimmed = [line](std::size_t end) {
        while (end > 1 && (isBlank(line[end - 1]) || line[end - 1] == '}')) --end;
        return end;
    };
    const std::size_t comment = std::min(line.find(" //"), line.size()), end = trimmed(comment);
    return line.substr(end, comment - end).find('}') == std::string_view::npos ? lineEnd : m_at + end;
}

void Lexer::dollar() {
    if (m_scan.at(m_at + 1) == '(') {
        emit(TokenKind::ExprOpen, m_at + 2);
        m_parens = 1;
    } else if (m_scan.wordStartsAt(m_at + 1)) {
        if (!operandFollows()) m_parens = 0;
        emit(TokenKind::ParamRef, m_scan.identEnd(m_at + 1));
        if (m_parens > 0) return;
    } else if (const std::size_t end = m_scan.bracedParamEnd(m_at); end > m_at) {
        emit(TokenKind::Unknown, end);
        if (m_parens > 0) return;
    } else {
        return unknown();
    }
    m_state = LexerState::AfterElement;
    m_sameLine = m_numbers = true;
}

/// In an expression: whether its last token can be compared. In `$(a/2 Mass=1` it cannot: the `)` is missing and Mass is a key.
bool Lexer::operandPrecedes() const {
    if (m_last != TokenKind::Word)
        return m_last == TokenKind::Number || m_last == TokenKind::Unit || m_last == TokenKind::CloseParen;
    std::size_t i = m_tokens.size(), words = 0;
    while (i > 0 && (isTrivia(m_tokens[i - 1].kind) || words++ == 0)) --i; // to the token before that word
    if (i == 0) return false;
    const TokenKind before = m_tokens[i - 1].kind;
    return before != TokenKind::Word && before != TokenKind::Number && before != TokenKind::Unit &&
           before != TokenKind::CloseParen && before != TokenKind::Dot;
}

void Lexer::hash() {
    m_parens = 0;
    std::size_t end = m_at + 1;
    while (isIdent(m_scan.at(end))) ++end;
    const std::string_view name = m_text.substr(m_at + 1, end - m_at - 1);
    const bool known = isDirectiveLike(name);
    if (!known && !(m_firstOnLine && !name.empty() && isIdentStart(name[0]))) {
        // A colour (#ff0000) in a value, or a comment in another language's syntax.
        return emit(TokenKind::Unknown, m_state == LexerState::Value && !name.empty() ? end : m_scan.lineEnd(m_at));
    }
    const bool first = m_firstOnLine;
    emit(TokenKind::Directive, end);
    m_state = LexerState::Structure;
    path(m_scan.skipBlanks(m_at), first);
}

/// The rest of the line up to a space before a comment. If the directive is not first on its line, a final `}` is excluded.
void Lexer::path(std::size_t from, bool firstOnLine) {
    std::size_t stop = from;
    if (m_scan.at(from) == '"') {
        for (++stop; stop < m_text.size() && m_scan.at(stop) != '"' && m_scan.at(stop) != '\n' && m_scan.at(stop) != '\r';)
            ++stop;
        if (m_scan.at(stop) == '"') ++stop;
    } else {
        stop = m_scan.lineEnd(from);
        for (std::size_t i = from; i < stop; ++i) {
            if (m_scan.commentAt(i) && (i == from || isBlank(m_scan.at(i - 1)))) stop = i;
        }
        while (stop > from && isBlank(m_scan.at(stop - 1))) --stop;
        if (!firstOnLine && stop > from && m_scan.at(stop - 1) == '}') --stop;
        while (stop > from && isBlank(m_scan.at(stop - 1))) --stop;
    }
    if (stop == from) return; // the parser reports the missing path
    if (from > m_at) emit(TokenKind::Space, from);
    emit(TokenKind::Path, stop);
}

void Lexer::punctuation() {
    const auto structure = [this](TokenKind kind) {
        m_state = LexerState::Structure;
        m_parens = 0;
        m_numbers = false;
        emit(kind, m_at + 1);
    };
    const auto valueAfter = [this](TokenKind kind, std::size_t length) {
        m_state = LexerState::Value;
        m_parens = 0;
        m_numbers = false;
        m_sameLine = true;
        emit(kind, m_at + length);
    };
    switch (m_scan.at(m_at)) {
    case '{': return structure(TokenKind::OpenBrace);
    case '}': return structure(TokenKind::CloseBrace);
    case '=':
        if (m_parens > 0 && m_scan.startsWith(m_at, "==")) return emit(TokenKind::Unknown, m_at + 2); // a comparison
        if (m_parens > 0 && operandPrecedes()) return emit(TokenKind::Equals, m_at + 1);              // meant as one
        return m_scan.startsWith(m_at, "==") ? valueAfter(TokenKind::Unknown, 2) : valueAfter(TokenKind::Equals, 1);
    case ':':
        if (m_parens > 0 && m_scan.at(m_at + 1) != '=' && operandPrecedes())
            return emit(TokenKind::Unknown, m_at + 1); // `a ? b : c`
        return m_scan.startsWith(m_at, ":=") ? valueAfter(TokenKind::Unknown, 2) : valueAfter(TokenKind::Unknown, 1);
    case ',':
        if (m_parens == 0 && m_state == LexerState::AfterElement) m_state = LexerState::Value;
        return emit(TokenKind::Comma, m_at + 1);
    case '(':
        if (m_parens > 0) ++m_parens;
        return emit(TokenKind::OpenParen, m_at + 1);
    case ')':
        if (m_parens > 0) --m_parens;
        return emit(TokenKind::CloseParen, m_at + 1);
    case '.': return emit(TokenKind::Dot, m_at + 1);
    case '+': return emit(TokenKind::Plus, m_at + 1);
    case '-': return emit(TokenKind::Minus, m_at + 1);
    case '*': return m_scan.startsWith(m_at, "*/") ? emit(TokenKind::Unknown, m_at + 2) : emit(TokenKind::Star, m_at + 1);
    case '/': return emit(TokenKind::Slash, m_at + 1);
    case '^': return emit(TokenKind::Caret, m_at + 1);
    default: return unknown();
    }
}

/// Quoted text with unsupported quotes, single punctuation characters, and runs of other bytes.
void Lexer::unknown() {
    if (m_scan.startsWith(m_at, kUnicodeMinus)) return emit(TokenKind::Minus, m_at + kUnicodeMinus.size());
    if (const std::size_t quoted = foreignQuoteEnd(m_text, m_at); quoted > m_at) {
        m_state = LexerState::AfterElement;
        m_sameLine = true;
        return emit(TokenKind::Unknown, quoted);
    }
    const char c = m_scan.at(m_at);
    const bool compares = m_parens > 0 && (c == '<' || c == '>' || c == '!') && m_scan.at(m_at + 1) == '=';
    if (compares) return emit(TokenKind::Unknown, m_at + 2);
    if (static_cast<unsigned char>(c) > ' ' && static_cast<unsigned char>(c) < 0x7F) return emit(TokenKind::Unknown, m_at + 1);
    // Invalid bytes and valid code points become separate tokens, since they are reported differently.
    const bool valid = codePointAt(m_text, m_at).valid && c != '\0';
    const bool invisible = m_scan.invisibleAt(m_at) > 0;
    std::size_t end = m_at;
    while (end < m_text.size()) {
        const CodePoint point = codePointAt(m_text, end);
        const auto byte = static_cast<unsigned char>(m_text[end]);
        if ((point.valid && byte != 0) != valid || (byte >= ' ' && byte < 0x7F) || isBlank(m_text[end]) || byte == '\n' ||
            byte == '\r')
            break;
        if (end > m_at &&
            (m_scan.startsWith(end, kUnicodeMinus) || (m_scan.invisibleAt(end) > 0) != invisible || m_scan.letterAt(end) > 0))
            break;
        end += point.length;
    }
    emit(TokenKind::Unknown, end);
}

} // namespace trundle
