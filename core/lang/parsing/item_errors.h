#pragma once
// Diagnostics for common mistakes between items: one message each, with a fix where it is obvious. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

class BraceBalance;

/// What a mistake is parsed as once it has been reported.
class BlockGrammar {
public:
    /// `Type {`, with `extra` tokens before the brace: a name, or unexpected tokens that were already reported.
    virtual void block(std::vector<Item>& out, int depth, std::size_t extra) = 0;
    virtual void blockBody(BlockItem& block, int depth) = 0;
    /// `Param name = value`, with whatever word in place of `Param`.
    virtual void param(std::vector<Item>& out, int depth) = 0;
    /// Skips to the `}` of a block whose `{` has been consumed, without parsing its content.
    virtual void skipBlockBody() = 0;
    [[nodiscard]] virtual Value value(std::string_view key, TextRange keyRange, TextRange equals) = 0;
    virtual void rejectReserved(const Name& name, std::string_view use) = 0;

protected:
    ~BlockGrammar() = default;
};

class ItemErrors : ParserPart {
public:
    ItemErrors(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, BraceBalance& balance)
        : ParserPart(tokens, report), m_grammar(grammar), m_balance(balance) {}

    /// Handles a word that begins neither an assignment nor a block.
    void strayWord(std::vector<Item>& out, int depth);
    /// A token that cannot begin an item. A run of them up to the next line, key or brace is one mistake.
    void unexpected(int depth);
    void strayBrace(bool tooEarly);
    /// `Mass 3` behind another value: `Config=A Mass 3`.
    void keyWithoutEquals(std::vector<Item>& out);

private:
    [[nodiscard]] bool restOfComment();
    [[nodiscard]] bool quotedName(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameThatBeginsWithDigit(std::vector<Item>& out, int depth);
    [[nodiscard]] bool missingEquals(std::vector<Item>& out);
    [[nodiscard]] bool nameOfTwoWords(std::vector<Item>& out, int depth);
    [[nodiscard]] bool missingBrace(std::vector<Item>& out, int depth);
    [[nodiscard]] bool missingBraceInLine(std::vector<Item>& out, int depth);
    [[nodiscard]] bool keyAndWord(std::vector<Item>& out, int depth);
    void readValue(std::vector<Item>& out);
    [[nodiscard]] bool explainUnexpected();
    void blockWithoutBrace(std::vector<Item>& out, int depth);
    [[nodiscard]] bool blockInBrackets(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameWithSigns(std::vector<Item>& out, int depth);
    void skipLine();

    BlockGrammar& m_grammar;
    BraceBalance& m_balance;
};

} // namespace trundle
