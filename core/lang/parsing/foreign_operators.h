#pragma once
// Operators and functions of other languages in `$( )`: one message each that says how it is written here. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

class ForeignOperators : ParserPart {
public:
    ForeignOperators(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    // Each reports what is at the current token and returns true, or returns false.
    bool behindOperand();         ///< `&&`, `||`, `and`, `or`, `?`, `if`, `%`, `mod`, `//`
    bool beforeOperand();         ///< `!`, `not`, `if` without parentheses
    bool bracedParam();           ///< `${a}`
    bool list(std::size_t start); ///< `$(0,0,1)`, read up to its first comma; `start`: the token `$(`
    void unknownFunction(const std::vector<std::string>& known);

    /// `%` is also the unit of a number, but not with an operand behind it.
    [[nodiscard]] bool isRemainder() const;
    /// Whether the current word can only be the unit of the number before it.
    [[nodiscard]] bool isUnit() const;

private:
    bool report(TextRange place, std::string message);
    [[nodiscard]] bool startsOperand(std::size_t ahead) const;
    [[nodiscard]] std::size_t logicalTokens() const;
    [[nodiscard]] std::size_t closeAhead() const;
};

} // namespace trundle
