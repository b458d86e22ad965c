#pragma once
// Diagnostics for common mistakes between items: one message each, with a fix where it is obvious. Private to core/lang.

#include "lang/parsing/missing_braces.h"

namespace trundle {

class ItemErrors : ParserPart {
public:
    ItemErrors(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, BraceBalance& balance)
        : ParserPart(tokens, report), m_grammar(grammar), m_balance(balance), m_braces(tokens, report, grammar, balance) {}

    [[nodiscard]] MissingBraces& braces() { return m_braces; }

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
    [[nodiscard]] bool keyAndWord(std::vector<Item>& out, int depth);
    void readValue(std::vector<Item>& out);
    [[nodiscard]] bool explainUnexpected();
    [[nodiscard]] bool blockInBrackets(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameWithSigns(std::vector<Item>& out, int depth);
    void skipLine();

    BlockGrammar& m_grammar;
    BraceBalance& m_balance;
    MissingBraces m_braces;
};

} // namespace trundle
