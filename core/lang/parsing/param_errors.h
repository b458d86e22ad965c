#pragma once
// Diagnostics for common mistakes in `Param name = value`: one message each. Private to core/lang.

#include <optional>

#include "lang/parsing/item_errors.h"

namespace trundle {

class ParamErrors : ParserPart {
public:
    ParamErrors(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar)
        : ParserPart(tokens, report), m_grammar(grammar) {}

    /// A Param whose value is not known, so that its uses are no mistakes.
    [[nodiscard]] static Item unknown(const Name& name);
    [[nodiscard]] static bool isType(std::string_view word); ///< of another language: `double`
    /// `Param "r" = 3`, `Param(r, 3)`, `Param r(3)`, `Param r { Value=3 }`, `Param { Name=r }`, which are read; false without one.
    [[nodiscard]] bool otherForm(std::vector<Item>& out);
    /// `Min=1 cm Max=2 cm` behind a Param, in the same line.
    void looseDescription(ParamItem& param);
    /// `Param = 3`, `Param 3x = 4`, `Param 5`; false if no such text is here.
    [[nodiscard]] bool withoutName();
    /// `Param $r = 3`, at its `Param`: the name without `$`; none if no such text is here.
    [[nodiscard]] std::optional<Name> dollarName();
    /// `Param a-b = 3`, `Param float a = 3`: reads the rest of the name; false without one.
    bool restOfName(Name& name);
    /// `let a = 3`, `const double a = 3`: read as a Param. A type before a key with a capital letter, or another word, is too much.
    [[nodiscard]] bool otherWord(std::vector<Item>& out, int depth);

    /// `[0.05, 0.2]` and `(0.05, 0.2)` behind a Param; false if it is no range of numbers.
    [[nodiscard]] bool limitsInBrackets();

private:
    [[nodiscard]] bool blockForm(std::vector<Item>& out);

    BlockGrammar& m_grammar;
};

} // namespace trundle
