#pragma once
// Converts bytes to tokens. Needs: any bytes. Result: tokens that cover each byte exactly once. Method: one pass. The meaning of
// a word depends on its position (a key, or a value that may contain . / \ -), so the lexer tracks a state and looks ahead at
// most to the end of one path.
// Assumptions: none about the bytes; broken UTF-8 becomes Unknown tokens, which the parser reports.

#include <string_view>
#include <vector>

#include "lang/characters.h"
#include "lang/token.h"

namespace trundle {

class Lexer {
public:
    explicit Lexer(std::string_view text) : m_text(text) {}
    /// All tokens, including the end token.
    [[nodiscard]] std::vector<Token> lex();
    /// Appends the next tokens, about `most`, without the end token.
    void lexSome(std::vector<Token>& out, std::size_t most);
    [[nodiscard]] bool atEnd() const { return m_at >= m_text.size(); }
    [[nodiscard]] std::size_t offset() const { return m_at; }

private:
    enum class LexerState { Structure, Value, AfterElement };

    // lookahead; all positions are byte offsets
    [[nodiscard]] char at(std::size_t i) const { return i < m_text.size() ? m_text[i] : '\0'; }
    [[nodiscard]] bool startsWith(std::size_t i, std::string_view what) const {
        return m_text.compare(i, what.size(), what) == 0;
    }
    [[nodiscard]] bool commentAt(std::size_t i) const { return at(i) == '/' && (at(i + 1) == '/' || at(i + 1) == '*'); }
    [[nodiscard]] std::size_t lineEnd(std::size_t from) const;
    [[nodiscard]] std::size_t afterLineEnd(std::size_t i) const { return i + (at(i) == '\r' && at(i + 1) == '\n' ? 2 : 1); }
    [[nodiscard]] std::size_t blankLinesEnd(std::size_t from) const; ///< after the last consecutive blank line
    [[nodiscard]] std::size_t commentsEnd(std::size_t from) const;   ///< last line end within consecutive blanks and comments
    [[nodiscard]] std::size_t skipBlanks(std::size_t from) const;
    [[nodiscard]] std::size_t skipTrivia(std::size_t from) const;
    [[nodiscard]] std::size_t letterAt(std::size_t i) const; ///< bytes of the letter or digit at `i`; 0 for anything else
    [[nodiscard]] bool wordStartsAt(std::size_t i) const { return letterAt(i) > 0 && !isDigit(at(i)); }
    [[nodiscard]] std::size_t invisibleAt(std::size_t i) const; ///< bytes of the invisible character at `i`
    [[nodiscard]] std::size_t identEnd(std::size_t from) const;
    [[nodiscard]] std::size_t wordEnd(std::size_t from) const;
    [[nodiscard]] std::size_t numberEnd(std::size_t from, bool sign) const; ///< `from` if no number begins there
    [[nodiscard]] std::size_t unitEnd(std::size_t from) const;              ///< `from` if no unit begins there
    [[nodiscard]] bool isKeyOrKind(std::size_t from, std::size_t end) const;
    [[nodiscard]] bool isNamedBlock(std::size_t end) const;
    [[nodiscard]] bool blockMayFollow() const;
    [[nodiscard]] bool isReservedWord(std::size_t from, std::size_t end) const;

    // tokens
    void emit(TokenKind kind, std::size_t end);
    void next();
    bool trivia();
    void word();
    void number(std::size_t end);
    void string();
    void dollar();
    void hash();
    void path(std::size_t from, bool firstOnLine);
    void punctuation();
    void unknown();
    void expressionLineEnd();

    std::string_view m_text;
    std::size_t m_at = 0;
    std::vector<Token> m_tokens;
    LexerState m_state = LexerState::Structure;
    int m_parens = 0;                               ///< open parentheses of an expression; 0 outside
    static constexpr std::size_t kMaxTrivia = 1000; ///< consecutive trivia tokens; further comment lines become one token
    std::size_t m_trivia = 0;                       ///< trivia tokens since the last significant token
    std::size_t m_continuedAt = 0;                  ///< in an expression: offset of the token after the trivia
    bool m_firstOnLine = true;                      ///< only blanks and comments precede on this line
    bool m_sameLine = false;                        ///< the last element is on this line
    TokenKind m_last = TokenKind::End;              ///< last token that is not trivia
    bool m_numbers = false;                         ///< the last element was a number
};

} // namespace trundle
