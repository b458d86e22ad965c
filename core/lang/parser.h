#pragma once
// Tokens to items, with recovery. Needs: the lexer's tokens. Gives: items, diagnostics. Method: recursive descent over the tokens that
// are no trivia; what cannot be read is reported once, where it can be mended, and skipped to the next key, brace or line.
// Promises: every loop consumes a token; blocks and expressions nest to fixed depths; the number of diagnostics is bounded. Tokens are
// read as they are needed, so that a large text of mistakes costs no more than its beginning.

#include <map>

#include "lang/lexer.h"
#include "lang/tree.h"

namespace trundle {

class Parser {
public:
    Parser(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens);
    [[nodiscard]] std::shared_ptr<const Tree> parse();

private:
    /// A token that is no trivia and whether a line end stands before it.
    struct Significant {
        std::uint32_t token;
        bool newLine;
    };
    /// A block whose `}` has not come yet.
    struct OpenBlock {
        TextRange name;               ///< its name, or its kind
        std::uint32_t openAt = 0;     ///< index of `{`
        int indent = -1;              ///< of its line; -1 when it is not first there
        bool indentedItems = false;   ///< an item stands deeper than the block: the author indents
        bool inlineItems = false;     ///< an item stands on the line of `{`
        bool bracket = false;         ///< `[` or `(` stands where `{` belongs
        std::size_t bracketFault = 0; ///< the message of that, counted from 1
    };
    /// A place where, by the indentation, a `}` is missing.
    struct MissingBrace {
        std::uint32_t openAt, before;
    };
    struct Sum {
        Expression expression;
        int height = 1;
        bool ok = true;
    };

    // parser.cpp: looking
    [[nodiscard]] const Token& token(std::size_t ahead = 0) const;
    [[nodiscard]] TokenKind kind(std::size_t ahead = 0) const { return token(ahead).kind; }
    [[nodiscard]] TextRange range(std::size_t ahead = 0) const { return token(ahead).range; }
    [[nodiscard]] std::string_view text(std::size_t ahead = 0) const { return m_source->slice(range(ahead)); }
    [[nodiscard]] std::string_view slice(TextRange r) const { return m_source->slice(r); }
    [[nodiscard]] bool newLine(std::size_t ahead = 0) const;
    [[nodiscard]] bool adjacent(std::size_t ahead = 0) const; ///< touches the token before it
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

    // token_reader.cpp: tokens as they are needed
    static constexpr std::size_t kLookAhead = 256;       ///< more than any rule looks ahead
    static constexpr std::size_t kMostDiagnostics = 100; ///< a text of garbage would otherwise cost its size in messages
    void readTokens();
    void takeToken(std::uint32_t index);
    [[nodiscard]] bool isHopeless();
    void endTokens(Tree::Extent extent);
    void checkLongWords();

    // parser.cpp: saying
    Diagnostic& report(Severity severity, Code code, TextRange r, std::string message);
    Diagnostic& error(Code code, TextRange r, std::string message) {
        return report(Severity::Error, code, r, std::move(message));
    }
    [[nodiscard]] bool isCutOff(TextRange r) const;
    [[nodiscard]] Diagnostic* lastAt(TextRange r); ///< the last one said, when it is at `r`
    void fix(Diagnostic& d, std::string title, std::vector<TextEdit> edits) const;
    [[nodiscard]] const std::string& lineEnd() const { return m_lineEnd; } ///< as the file has it
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
    void refuseReserved(const Name& name, std::string_view use);

    // mistakes.cpp: what people write instead
    [[nodiscard]] bool restOfComment();
    void strayWord(std::vector<Item>& out, int depth);
    void unexpected(int depth);
    bool knownUnexpected();
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
    [[nodiscard]] int indentOf(std::uint32_t offset) const; ///< -1 when something stands before it on its line
    void noteIndent();
    void noteEarlyClose(int indent, std::size_t brace);
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

    // value_mistakes.cpp
    void checkNumberTail(Element& e, Value& v);
    void signedElement(Element& e, Value& v);
    void goesOn(Element& e, Value& v);
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
    bool m_allRead = false;   ///< no more tokens come
    bool m_newLine = true;    ///< a line end stands before the next token
    std::size_t m_itemAt = 0; ///< where the item that is being read begins
    std::shared_ptr<Tree> m_tree;
    std::vector<Significant> m_significant;
    std::vector<std::uint32_t> m_invisible; ///< tokens that the grammar does not see
    std::vector<std::uint32_t> m_long;      ///< likewise, for their length
    std::vector<Diagnostic> m_diagnostics;
    Diagnostic m_unsaid; ///< takes what is said beyond the limit
    std::size_t m_at = 0;
    std::vector<OpenBlock> m_open;
    std::vector<MissingBrace> m_suspects;  ///< of this run
    std::vector<MissingBrace> m_onOneLine; ///< of this run: a block on one line, then one that stands no deeper
    std::vector<MissingBrace> m_assumed;   ///< braces taken as there in this run
    std::vector<std::uint32_t> m_early;    ///< `}` of this run that may have come too early
    std::vector<std::uint32_t> m_ignored;  ///< `}` taken as not there in this run
    int m_strays = 0;                      ///< `}` of this run that closed nothing
    std::string m_lineEnd = "\n";
    bool m_unclosed = false; ///< a block of this run stayed open to the end
    int m_brackets = 0;      ///< foreign brackets open in the value being read
};

} // namespace trundle
