#pragma once
// Parses `$( ... )`: sums, products, powers (right-associative, binding stronger than a sign), calls. Depth is bounded: nested
// parentheses use recursion here, and long sums use recursion in the code that evaluates them. Private to core/lang.

#include "lang/parsing/foreign_operators.h"

namespace trundle {

/// Whether `$( )` knows a function of this name.
[[nodiscard]] bool isFunction(std::string_view name);

class ExpressionParser : ParserPart {
public:
    ExpressionParser(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report), m_foreign(tokens, report) {}

    /// The expression whose `$(` is the current token; `v` is broken if it has errors.
    void element(Element& e, Value& v);

private:
    struct Sum {
        Expression expression;
        int height = 1;
        bool ok = true;
    };
    Sum whole(int depth);
    Sum comparison(int depth);
    Sum sum(int depth);
    Sum product(int depth);
    Sum signedTerm(int depth);
    Sum power(int depth);
    Sum primary(int depth);
    Sum number();
    Sum call(int depth);
    Sum binary(Expression::Op op, Sum left, Sum right);
    static Sum failed();
    Sum fault(Code code, TextRange r, std::string message);
    Sum unclosed(TextRange open);
    void skipToEnd(std::size_t start);
    void withDollar();

    ForeignOperators m_foreign;
    std::size_t m_dollar = 0; ///< 1-based index of the message about `$` in the current expression
};

} // namespace trundle
