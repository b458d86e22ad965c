#pragma once
// Diagnostics for common mistakes in `Param name = value`: one message each. Private to core/lang.

#include <optional>

#include "lang/parsing/item_errors.h"

namespace trundle {

class ParamErrors : ParserPart {
public:
    ParamErrors(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar)
        : ParserPart(tokens, report), m_grammar(grammar) {}

    /// `Param = 3`, `Param 3x = 4`, `Param 5`; false if no such text is here.
    [[nodiscard]] bool withoutName();
    /// `Param $r = 3`, at its `Param`: the name without `$`; none if no such text is here.
    [[nodiscard]] std::optional<Name> dollarName();
    /// `Param a-b = 3`, `Param float a = 3`: reads the rest of the name; false without one.
    bool restOfName(Name& name);
    /// `let a = 3`, `const double a = 3`: read as a Param. A type before a key with a capital letter, or another word, is too much.
    [[nodiscard]] bool otherWord(std::vector<Item>& out, int depth);

private:
    BlockGrammar& m_grammar;
};

} // namespace trundle
