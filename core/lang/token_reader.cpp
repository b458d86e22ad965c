// Supplies the parser with tokens: lexes them in chunks, until the end or until the limits on errors and size are exceeded.

#include <algorithm>

#include "lang/parser.h"

namespace trundle {

namespace {

constexpr std::size_t kPiece = 4096;           // tokens read at a time
constexpr std::size_t kAlwaysRead = 100'000;   // tokens: a text of up to this size is always read to its end
constexpr std::size_t kLongestItem = 100'000;  // tokens of one assignment, or of one run of unreadable text
constexpr std::uint32_t kShownOfLongWord = 40; // bytes covered by the range of its diagnostic

} // namespace

void Parser::readTokens() {
    std::vector<Token>& tokens = m_tree->m_tokens;
    while (!m_allRead && m_at + kLookAhead >= m_significant.size()) {
        const std::size_t before = tokens.size();
        m_lexer.lexSome(tokens, kPiece);
        for (std::size_t i = before; i < tokens.size(); ++i) takeToken(static_cast<std::uint32_t>(i));
        if (m_lexer.atEnd()) endTokens(Tree::Extent::Whole);
        else if (isUnrecoverable()) endTokens(Tree::Extent::Unrecoverable);
        else if (tokens.size() >= m_mostTokens) endTokens(Tree::Extent::Limited);
    }
}

void Parser::takeToken(std::uint32_t index) {
    const Token& token = m_tree->m_tokens[index];
    if (token.kind == TokenKind::LineEnd || token.kind == TokenKind::Bom) m_newLine = true;
    if (isTrivia(token.kind)) return;
    if (isTooLong(token)) return m_long.push_back(index);
    if (token.kind == TokenKind::Unknown && checkedAsBytes(token.range)) return m_invisible.push_back(index);
    m_significant.push_back({index, m_newLine});
    m_newLine = false;
}

/// Whether to stop reading: more errors than are listed, or one item beyond the size limit.
bool Parser::isUnrecoverable() {
    if (m_tree->m_tokens.size() < kAlwaysRead) return false;
    if (m_diagnostics.size() > kMaxDiagnostics) {
        m_diagnostics.back().message = "too many mistakes, the rest of this file is not read";
        return true;
    }
    const std::size_t unseen = m_long.size() + m_invisible.size();
    if (m_significant.size() - m_itemAt < kLongestItem && unseen < kLongestItem) return false;
    const TextRange begin = m_tree->m_tokens[m_significant.empty() ? 0 : m_significant[m_itemAt].token].range;
    const auto here = static_cast<std::uint32_t>(m_lexer.offset());
    error(Code::TooLarge, {here, here},
          "what begins in line " + std::to_string(m_source->position(begin.begin).line) +
              " has more than 100000 words; the rest of this file is not read");
    return true;
}

/// Appends the last tokens: the unread rest of the text as one token, and the end token.
void Parser::endTokens(Tree::Extent extent) {
    const auto from = static_cast<std::uint32_t>(m_lexer.offset()), size = static_cast<std::uint32_t>(m_source->bytes().size());
    std::vector<Token>& tokens = m_tree->m_tokens;
    if (from < size) tokens.push_back({TokenKind::Unknown, {from, size}});
    m_significant.push_back({static_cast<std::uint32_t>(tokens.size()), m_newLine});
    tokens.push_back({TokenKind::End, {size, size}});
    m_tree->m_extent = extent;
    m_tree->m_readTo = from;
    m_allRead = true;
}

void Parser::checkLongWords() {
    for (const std::uint32_t i : m_long) {
        const Token& token = m_tree->m_tokens[i];
        error(Code::TooLarge, {token.range.begin, std::min(token.range.end, token.range.begin + kShownOfLongWord)},
              std::to_string(token.range.size()) +
                  " bytes without a blank; a word, a number or a path may have 4096, a quoted text 65536");
    }
}

} // namespace trundle
