#pragma once
// Converts tokens to items, with error recovery. Needs: the lexer's tokens. Result: items and diagnostics. Method: recursive
// descent over the tokens that are not trivia; unreadable text is reported once, where it can be corrected, and skipped up to the
// next key, brace or line.
// Promises: every loop consumes a token; blocks and expressions have a maximum depth; the number of diagnostics is bounded.
// Tokens are lexed on demand, so that a large text full of errors is not lexed to its end.

#include <map>

#include "lang/lexer.h"
#include "lang/tree.h"

namespace trundle {

class Parser {
public:
    Parser(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens);
    [[nodiscard]] std::shared_ptr<const Tree> parse();

private:
    /// A token that is not trivia, and whether a line end precedes it.
    struct Significant {
        std::uint32_t token;
        bool newLine;
    };
    /// A block whose `}` has not been read yet.
    struct OpenBlock {
        TextRange name;               ///< its name, otherwise its kind
        std::uint32_t openAt = 0;     ///< index of `{`
        int indent = -1;              ///< of its line; -1 if it is not first on its line
        bool indentedItems = false;   ///< an item is indented deeper than the block, so indentation is meaningful
        bool inlineItems = false;     ///< an item is on the line of `{`
        bool bracket = false;         ///< `[` or `(` was written instead of `{`
        std::size_t bracketFault = 0; ///< 1-based index of its diagnostic; 0: none
    };
    /// A position where, according to the indentation, a `}` is missing.
    struct MissingBrace {
        std::uint32_t openAt, before;
    };
    struct Sum {
        Expression expression;
        int height = 1;
        bool ok = true;
    };

    // parser.cpp: lookahead
    [[nodiscard]] const Token& token(std::size_t ahead = 0) const;
    [[nodiscard]] TokenKind kind(std::size_t ahead = 0) const { return token(ahead).kind; }
    [[nodiscard]] TextRange range(std::size_t ahead = 0) const { return token(ahead).range; }
    [[nodiscard]] std::string_view text(std::size_t ahead = 0) const { return m_source->slice(range(ahead)); }
    [[nodiscard]] std::string_view slice(TextRange r) const { return m_source->slice(r); }
    [[nodiscard]] bool newLine(std::size_t ahead = 0) const;
    [[nodiscard]] bool adjacent(std::size_t ahead = 0) const; ///< no trivia between it and the token before
    [[nodiscard]] TextRange previous() const;
    [[nodiscard]] bool atEnd() const { return kind() == TokenKind::End; }
    [[nodiscard]] bool wrongEquals(std::size_t ahead) const; ///< `==`, `:=` or `:`
    [[nodiscard]] bool startsItem() const;                   ///< a key before `=`, a kind before `{`, Param
    [[nodiscard]] bool namedBlock() const {
        return kind() == TokenKind::Word && kind(1) == TokenKind::Word && kind(2) == TokenKind::OpenBrace;
    }
    void advance() {
        if (m_at + 1 < m_significant.size()) ++m_at;
        if (!m_allRead && m_at + kLookAhead >= m_significant.size()) readTokens();
    }

    // token_reader.cpp: reads tokens on demand
    static constexpr std::size_t kLookAhead = 256;       ///< more than any rule looks ahead
    static constexpr std::size_t kMaxDiagnostics = 100;  ///< bounds the number of messages for an unreadable text
    void readTokens();
    void takeToken(std::uint32_t index);
    [[nodiscard]] bool isUnrecoverable();
    void endTokens(Tree::Extent extent);
    void checkLongWords();

    // parser.cpp: reporting
    Diagnostic& report(Severity severity, Code code, TextRange r, std::string message);
    Diagnostic& error(Code code, TextRange r, std::string message) {
        return report(Severity::Error, code, r, std::move(message));
    }
    [[nodiscard]] bool isCutOff(TextRange r) const;
    [[nodiscard]] Diagnostic* lastAt(TextRange r); ///< the last diagnostic if its range is `r`
    void fix(Diagnostic& d, std::string title, std::vector<TextEdit> edits) const;
    [[nodiscard]] const std::string& lineEnd() const { return m_lineEnd; } ///< as in the file
    [[nodiscard]] TextEdit edit(TextRange r, std::string text) const { return {{m_file, r}, std::move(text)}; }

    // parser.cpp: items
    void run();
    void items(std::vector<Item>& out, int depth);
    void item(std::vector<Item>& out, int depth);
    void assignment(std::vector<Item>& out);
    void param(std::vector<Item>& out);
    void block(std::vector<Item>& out, int depth, std::size_t extra);
    void blockBody(BlockItem& block, int depth);
    void skipBlockBody();
    void directive(std::vector<Item>& out);
    [[nodiscard]] std::pair<std::string, TextRange> directivePath(TextRange directive);
    [[nodiscard]] Name name(std::size_t ahead = 0) const;
    void rejectReserved(const Name& name, std::string_view use);

    // syntax_errors.cpp: common mistakes
    [[nodiscard]] bool restOfComment();
    void strayWord(std::vector<Item>& out, int depth);
    void unexpected(int depth);
    bool explainUnexpected();
    void blockWithoutBrace(std::vector<Item>& out, int depth);
    [[nodiscard]] bool blockInBrackets(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameWithSigns(std::vector<Item>& out, int depth);
    void skipLine();
    void strayBrace(bool tooEarly);
    [[nodiscard]] bool isUtf16() const;
    void checkBytes();
    void checkInvisible();
    [[nodiscard]] bool checkedAsBytes(TextRange r) const;
    void checkComments();

    // balance.cpp: braces
    [[nodiscard]] int indentOf(std::uint32_t offset) const; ///< -1 if it is not first on its line
    void recordIndent();
    void recordEarlyClose(int indent, std::size_t brace);
    [[nodiscard]] bool ignoredBrace() const;
    [[nodiscard]] bool assume();
    [[nodiscard]] std::vector<MissingBrace> likelyMissing() const;
    [[nodiscard]] bool foreignClose() const;
    [[nodiscard]] bool closedHere(const OpenBlock& block) const;
    void reportUnclosed(const OpenBlock& block, std::uint32_t place);

    // value_parser.cpp
    [[nodiscard]] Value value(std::string_view key, TextRange keyRange, TextRange equals);
    [[nodiscard]] bool startsElement() const;
    [[nodiscard]] bool element(Value& v);
    void wordElement(Element& e);
    void numberElement(Element& e, Value& v);
    void stringElement(Element& e, Value& v);
    bool afterElement(Value& v, std::vector<TextRange>& gaps);
    [[nodiscard]] bool openBracket() const;

    // value_syntax_errors.cpp: common mistakes in values
    void checkNumberTail(Element& e, Value& v);
    void signedElement(Element& e, Value& v);
    void continuesAt(Element& e, Value& v);
    void foreignQuotes(Element& e, Value& v);
    void unquotedText(Element& e, Value& v);
    void arithmetic(Element& e, Value& v);
    void reportGaps(Value& v, const std::vector<TextRange>& gaps);
    void reportBrackets(Value& v, TextRange bracket, const std::vector<TextRange>& gaps);
    [[nodiscard]] bool unitInPieces(Element& e);
    void unicodeMinus(TextRange r);

    // expression_parser.cpp
    void expressionElement(Element& e, Value& v);
    Sum sum(int depth);
    Sum product(int depth);
    Sum signedTerm(int depth);
    Sum power(int depth);
    Sum primary(int depth);
    Sum call(int depth);
    Sum binary(Expression::Op op, Sum left, Sum right);
    Sum expressionFault(Code code, TextRange r, std::string message);

    std::shared_ptr<const SourceText> m_source;
    FileId m_file;
    std::size_t m_mostTokens;
    Lexer m_lexer;
    bool m_allRead = false;   ///< the lexer is at its end
    bool m_newLine = true;    ///< a line end precedes the next token
    std::size_t m_itemAt = 0; ///< where the current item begins
    std::shared_ptr<Tree> m_tree;
    std::vector<Significant> m_significant;
    std::vector<std::uint32_t> m_invisible; ///< tokens that the grammar skips
    std::vector<std::uint32_t> m_long;      ///< likewise, because they are too long
    std::vector<Diagnostic> m_diagnostics;
    Diagnostic m_unreported; ///< receives diagnostics beyond the limit
    std::size_t m_at = 0;
    std::vector<OpenBlock> m_open;
    std::vector<MissingBrace> m_suspects;  ///< of this run
    std::vector<MissingBrace> m_onOneLine; ///< of this run: a block on one line followed by an item that is not indented deeper
    std::vector<MissingBrace> m_assumed;   ///< braces assumed to exist in this run
    std::vector<std::uint32_t> m_early;    ///< `}` of this run that may be premature
    std::vector<std::uint32_t> m_ignored;  ///< `}` ignored in this run
    int m_unmatchedBraces = 0;             ///< number of `}` in this run without an open block
    std::string m_lineEnd = "\n";
    bool m_unclosed = false; ///< a block of this run was not closed
    int m_brackets = 0;      ///< open unsupported brackets in the current value
};

} // namespace trundle
