#pragma once
// Diagnostics for what belongs in `$( )` and is written without it: one message each, with a fix where it is short. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

/// Whether a token is `+ - * / ^`.
[[nodiscard]] bool isOperator(TokenKind kind);

inline constexpr const char* kDegrees = "; angles are in degrees";

/// `pi`, `width/2`: a word that may be meant as arithmetic.
[[nodiscard]] bool isQuotient(std::string_view word);

class ArithmeticErrors : ParserPart {
public:
    ArithmeticErrors(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    /// `2*x`, `(x)`: an element that is, or continues as, arithmetic.
    void arithmetic(Element& e, Value& v);
    /// `vec3(1,2,3)`, a function that there is not; false if the element does not continue so.
    [[nodiscard]] bool otherCall(Element& e, Value& v);
    /// `pi/2` between numbers, which is also a word.
    [[nodiscard]] bool wordAmongNumbers(Element& e, Value& v);
    /// `$if(a, b, c)`.
    void calledParam(Element& e, Value& v);
    /// `$n > 2`; false if the element does not continue so.
    [[nodiscard]] bool comparison(Element& e, Value& v);
    /// `$sizes[0]`; false if the element does not continue so.
    [[nodiscard]] bool elementOfList(Element& e, Value& v);
};

} // namespace trundle
