#pragma once
// Diagnostics for loops, conditions, definitions and templates of other languages: one message each, and what they hold is skipped.
// Private to core/lang.

#include "lang/parsing/block_grammar.h"

namespace trundle {

class BraceBalance;

class ControlFlow : ParserPart {
public:
    ControlFlow(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, const BraceBalance& balance)
        : ParserPart(tokens, report), m_grammar(grammar), m_balance(balance) {}

    // Each reports what begins here and returns true, or returns false.
    [[nodiscard]] bool loop();       ///< `for i = 1 to 4 {`, `if $n > 3 {`, `for i in range(3):`, `Body[4] wheel {`
    [[nodiscard]] bool definition(); ///< `def wheel(r) {`, `class Wheel {`
    [[nodiscard]] bool markup();     ///< `{% for i in x %}`, up to its `{% endfor %}`
    /// Skips the lines below that are indented deeper than `indent`, and those that begin with `sign` and are indented as deep.
    void skipIndented(int indent, std::string_view sign = {});

private:
    [[nodiscard]] bool array();
    void otherwise();
    void skipTag();
    [[nodiscard]] bool tagAhead(std::string_view word) const;

    BlockGrammar& m_grammar;
    const BraceBalance& m_balance;
};

} // namespace trundle
