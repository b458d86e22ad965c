#pragma once
// The tokens of a text that are not trivia, with lookahead. They are lexed on demand, so that a large text full of errors is not lexed
// to its end. Private to core/lang.

#include <string>
#include <vector>

#include "lang/lexer.h"
#include "lang/parsing/syntax_reporter.h"
#include "lang/tree.h"

namespace trundle {

class TokenCursor {
public:
    /// Fills `tokens`, which belong to the tree; stops after about `most`.
    TokenCursor(const SourceText& source, std::vector<Token>& tokens, SyntaxReporter& report, std::size_t most);
    /// Reads the first tokens; of a text that is not readable, none.
    void start(bool readable);
    void rewind() { m_at = 0; }

    [[nodiscard]] TokenKind kind(std::size_t ahead = 0) const { return token(ahead).kind; }
    [[nodiscard]] TextRange range(std::size_t ahead = 0) const { return token(ahead).range; }
    [[nodiscard]] std::string_view text(std::size_t ahead = 0) const { return m_source.slice(range(ahead)); }
    [[nodiscard]] bool newLine(std::size_t ahead = 0) const;  ///< a line end precedes it
    [[nodiscard]] bool adjacent(std::size_t ahead = 0) const; ///< no trivia between it and the token before
    [[nodiscard]] TextRange previous() const;
    [[nodiscard]] bool atEnd() const { return kind() == TokenKind::End; }
    [[nodiscard]] std::size_t position() const { return m_at; }
    [[nodiscard]] bool newLineAt(std::size_t position) const { return m_significant[position].newLine; }
    [[nodiscard]] const Token& at(std::size_t position) const { return m_tokens[m_significant[position].token]; }

    // What the tokens ahead look like.
    [[nodiscard]] bool wrongEquals(std::size_t ahead) const;    ///< `==`, `:=` or `:`
    [[nodiscard]] bool startsItem(std::size_t ahead = 0) const; ///< a key before `=`, a kind before `{`, Param
    [[nodiscard]] bool startsElement() const;                   ///< of a value
    [[nodiscard]] bool namedBlock() const {
        return kind() == TokenKind::Word && kind(1) == TokenKind::Word && kind(2) == TokenKind::OpenBrace;
    }

    void advance();
    void beginItem() { m_itemAt = m_at; } ///< one item, or one run of unreadable text, has a maximum size

    [[nodiscard]] const SourceText& source() const { return m_source; }
    [[nodiscard]] const std::string& lineEnd() const { return m_lineEnd; } ///< as in the file
    [[nodiscard]] const std::vector<Token>& all() const { return m_tokens; }
    [[nodiscard]] Tree::Extent extent() const { return m_extent; }
    [[nodiscard]] std::uint32_t readTo() const { return m_readTo; }
    // Tokens that the grammar skips, by their index in all().
    [[nodiscard]] const std::vector<std::uint32_t>& invisible() const { return m_invisible; }
    [[nodiscard]] const std::vector<std::uint32_t>& tooLong() const { return m_long; }

private:
    /// A token that is not trivia, and whether a line end precedes it.
    struct Significant {
        std::uint32_t token;
        bool newLine;
    };
    static constexpr std::size_t kLookAhead = 256; ///< more than any rule looks ahead

    [[nodiscard]] const Token& token(std::size_t ahead) const;
    void readTokens();
    void takeToken(std::uint32_t index);
    [[nodiscard]] bool isUnrecoverable();
    void endTokens(Tree::Extent extent);

    const SourceText& m_source;
    std::vector<Token>& m_tokens;
    SyntaxReporter& m_report;
    std::size_t m_most;
    Lexer m_lexer;
    std::string m_lineEnd = "\n";
    bool m_allRead = false;   ///< the lexer is at its end
    bool m_newLine = true;    ///< a line end precedes the next token
    std::size_t m_itemAt = 0; ///< where the current item begins
    std::size_t m_at = 0;
    std::vector<Significant> m_significant;
    std::vector<std::uint32_t> m_invisible, m_long;
    std::size_t m_ofLongWords = 0; ///< what they count beside themselves
    Tree::Extent m_extent = Tree::Extent::Whole;
    std::uint32_t m_readTo = 0;
};

} // namespace trundle
