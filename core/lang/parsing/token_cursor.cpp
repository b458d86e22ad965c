#include "lang/parsing/token_cursor.h"

#include <algorithm>

#include "base/utf8.h"
#include "lang/characters.h"

namespace trundle {
namespace {

constexpr std::size_t kPiece = 4096;          // tokens read at a time
constexpr std::size_t kAlwaysRead = 100'000;  // tokens: a text of up to this size is always read to its end
constexpr std::size_t kLongestItem = 100'000; // tokens of one assignment, or of one run of unreadable text
constexpr std::size_t kLongWord = 64;         // letters; a longer word counts as several, as it takes the memory of several
constexpr std::size_t kNearCut = 8;           // tokens; an error this close to the end of parsing may be caused by it

/// True for NUL, invalid UTF-8 and invisible characters: they are reported by separate checks and skipped by the grammar.
bool checkedAsBytes(std::string_view bytes, TextRange r) {
    const CodePoint point = codePointAt(bytes, r.begin);
    return !point.valid || point.value == 0 || isInvisible(point.value);
}

} // namespace

TokenCursor::TokenCursor(const SourceText& source, std::vector<Token>& tokens, SyntaxReporter& report, std::size_t most)
    : m_source(source), m_tokens(tokens), m_report(report), m_most(most), m_lexer(source.bytes()) {
    const std::string_view bytes = source.bytes();
    if (const std::size_t first = bytes.find_first_of("\r\n"); first != std::string_view::npos)
        m_lineEnd = bytes.substr(first, bytes.substr(first, 2) == "\r\n" ? 2 : 1);
}

void TokenCursor::start(bool readable) {
    if (readable) readTokens();
    else endTokens(Tree::Extent::Unrecoverable);
}

void TokenCursor::advance() {
    if (m_at + 1 < m_significant.size()) ++m_at;
    if (!m_allRead && m_at + kLookAhead >= m_significant.size()) readTokens();
}

const Token& TokenCursor::token(std::size_t ahead) const {
    return m_tokens[m_significant[std::min(m_at + ahead, m_significant.size() - 1)].token];
}

bool TokenCursor::newLine(std::size_t ahead) const {
    return m_significant[std::min(m_at + ahead, m_significant.size() - 1)].newLine;
}

bool TokenCursor::adjacent(std::size_t ahead) const {
    return m_at + ahead > 0 && m_at + ahead < m_significant.size() &&
           token(ahead).range.begin == m_tokens[m_significant[m_at + ahead - 1].token].range.end;
}

TextRange TokenCursor::previous() const { return m_at == 0 ? TextRange{} : m_tokens[m_significant[m_at - 1].token].range; }

bool TokenCursor::wrongEquals(std::size_t ahead) const {
    if (kind(ahead) != TokenKind::Unknown) return false;
    const std::string_view sign = text(ahead);
    if (sign == "==" || sign == ":=") return true;
    const std::size_t after = range(ahead).end;
    const std::string_view bytes = m_source.bytes();
    const bool scope = adjacent(ahead) && after < bytes.size() && bytes[after] == ':'; // `a::b`
    return sign == ":" && !scope && !(after < bytes.size() && (bytes[after] == '/' || bytes[after] == '\\'));
}

bool TokenCursor::startsItem(std::size_t ahead) const {
    if (kind(ahead) != TokenKind::Word) return false;
    const std::size_t next = ahead + 1;
    if (text(ahead) == "Param" || kind(next) == TokenKind::Equals || kind(next) == TokenKind::OpenBrace || wrongEquals(next))
        return true;
    constexpr std::size_t kLongestPath = 64;
    std::size_t i = next;
    while (i < 2 * kLongestPath && kind(i) == TokenKind::Dot && kind(i + 1) == TokenKind::Word && adjacent(i) && adjacent(i + 1))
        i += 2;
    return i > next && kind(i) == TokenKind::Equals;
}

bool TokenCursor::startsElement() const {
    switch (kind()) {
    case TokenKind::Number:
    case TokenKind::String:
    case TokenKind::ParamRef:
    case TokenKind::ExprOpen: return true;
    case TokenKind::Unknown: return isBracedParam(text());
    case TokenKind::Word: return !startsItem();
    default: return false;
    }
}

void TokenCursor::readTokens() {
    while (!m_allRead && m_at + kLookAhead >= m_significant.size()) {
        const std::size_t before = m_tokens.size();
        m_lexer.lexSome(m_tokens, kPiece);
        for (std::size_t i = before; i < m_tokens.size(); ++i) takeToken(static_cast<std::uint32_t>(i));
        if (m_lexer.atEnd()) endTokens(Tree::Extent::Whole);
        else if (isUnrecoverable()) endTokens(Tree::Extent::Unrecoverable);
        else if (m_tokens.size() + m_ofLongWords >= m_most) endTokens(Tree::Extent::Limited);
    }
}

void TokenCursor::takeToken(std::uint32_t index) {
    const Token& token = m_tokens[index];
    if (token.kind == TokenKind::LineEnd || token.kind == TokenKind::Bom) m_newLine = true;
    if (isTrivia(token.kind)) return;
    m_ofLongWords += token.range.size() / kLongWord;
    if (isTooLong(token)) return m_long.push_back(index);
    if (token.kind == TokenKind::Unknown && checkedAsBytes(m_source.bytes(), token.range)) return m_invisible.push_back(index);
    m_significant.push_back({index, m_newLine});
    m_newLine = false;
}

/// Whether to stop reading: more errors than are listed, or one item beyond the size limit.
bool TokenCursor::isUnrecoverable() {
    if (m_tokens.size() < kAlwaysRead) return false;
    if (m_report.isFull()) {
        m_report.changeLast("too many mistakes, the rest of this file is not read");
        return true;
    }
    const std::size_t unseen = m_long.size() + m_invisible.size();
    if (m_significant.size() - m_itemAt < kLongestItem && unseen < kLongestItem) return false;
    const TextRange begin = m_tokens[m_significant.empty() ? 0 : m_significant[m_itemAt].token].range;
    const auto here = static_cast<std::uint32_t>(m_lexer.offset());
    m_report.error(Code::TooLarge, {here, here},
                   "what begins in line " + std::to_string(m_source.position(begin.begin).line) +
                       " has more than 100000 words; the rest of this file is not read");
    return true;
}

/// Appends the last tokens: the unread rest of the text as one token, and the end token.
void TokenCursor::endTokens(Tree::Extent extent) {
    const auto from = static_cast<std::uint32_t>(m_lexer.offset()), size = static_cast<std::uint32_t>(m_source.bytes().size());
    if (from < size) m_tokens.push_back({TokenKind::Unknown, {from, size}});
    m_significant.push_back({static_cast<std::uint32_t>(m_tokens.size()), m_newLine});
    m_tokens.push_back({TokenKind::End, {size, size}});
    m_extent = extent;
    m_readTo = from;
    if (extent != Tree::Extent::Whole && m_significant.size() > kNearCut)
        m_report.setCut(at(m_significant.size() - kNearCut).range.begin);
    m_allRead = true;
}

} // namespace trundle
