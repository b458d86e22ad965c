#pragma once
// Converts bytes to tokens. Needs: any bytes. Result: tokens that cover each byte exactly once. Method: one pass. The meaning of
// a word depends on its position (a key, or a value that may contain . / \ -), so the lexer tracks a state and looks ahead at
// most to the end of one path.
// Assumptions: none about the bytes; broken UTF-8 becomes Unknown tokens, which the parser reports.

#include <string_view>
#include <vector>

#include "lang/text_scanner.h"
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

    void emit(TokenKind kind, std::size_t end);
    void next();
    bool trivia();
    void word();
    void number(std::size_t end);
    void unitInExpression();
    void string();
    [[nodiscard]] std::size_t beforeBraces(std::size_t lineEnd) const;
    void dollar();
    void hash();
    void path(std::size_t from, bool firstOnLine);
    void punctuation();
    void unknown();
    void expressionLineEnd();
    [[nodiscard]] bool blockMayFollow() const;
    [[nodiscard]] bool operandPrecedes() const;
    [[nodiscard]] bool operandFollows() const;
    [[nodiscard]] bool isQuotient() const;

    std::string_view m_text;
    TextScanner m_scan{m_text};
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
