#pragma once
// Blocks without their `{`: where it is surely missing, one message, and the block is read as if it were there. Private to core/lang.

#include "lang/parsing/block_grammar.h"

namespace trundle {

class BraceBalance;

class MissingBraces : ParserPart {
public:
    MissingBraces(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, BraceBalance& balance)
        : ParserPart(tokens, report), m_grammar(grammar), m_balance(balance) {}

    /// `Hinge w Parent=a }`: a block only where BraceBalance assumes so; otherwise notes that it may be one and returns false.
    [[nodiscard]] bool assumed(std::vector<Item>& out, int depth);
    /// `Min=1 cm }` behind a Param, likewise.
    [[nodiscard]] bool assumedDescription(const ParamItem& param);
    /// `Robot r` with indented items below; false if no such text is here.
    [[nodiscard]] bool beforeIndented(std::vector<Item>& out, int depth);
    /// `Body chassis:` and, deeper, the lines that belong to it; false if no such text is here.
    [[nodiscard]] bool byIndentation(std::vector<Item>& out, int depth);
    /// `Body b Sphere s { } }`; false if no such text is here.
    [[nodiscard]] bool beforeBlock(std::vector<Item>& out, int depth);

private:
    void blockWithoutBrace(std::vector<Item>& out, int depth, bool named, bool byIndentation = false);
    void skipIndented(int indent);
    Diagnostic& expected(bool named);

    BlockGrammar& m_grammar;
    BraceBalance& m_balance;
};

} // namespace trundle
