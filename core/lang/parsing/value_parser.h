#pragma once
// Parses values: elements separated by commas. Private to core/lang.

#include "lang/parsing/expression_parser.h"
#include "lang/parsing/value_errors.h"

namespace trundle {

class ValueParser : ParserPart {
public:
    ValueParser(TokenCursor& tokens, SyntaxReporter& report)
        : ParserPart(tokens, report), m_expressions(tokens, report),
          m_errors(tokens, report, [this](Value& v) { return element(v); }) {}
    ValueParser(const ValueParser&) = delete;
    ValueParser& operator=(const ValueParser&) = delete;

    /// The elements after `=`. `equals` is the position of the first element if there is none.
    [[nodiscard]] Value value(std::string_view key, TextRange keyRange, TextRange equals);
    /// The same for a Param, whose value may be followed by a description in braces.
    [[nodiscard]] Value paramValue(std::string_view key, TextRange keyRange, TextRange equals);
    /// Parses one element into `v`; false if none begins here.
    [[nodiscard]] bool element(Value& v);
    /// Position of the key without `=` at which the last such value ended: `Mass` of `Config=A Mass 1`.
    [[nodiscard]] std::size_t keyAt() const { return m_keyAt; }

private:
    void skipEquals(Value& v); ///< of which one is enough
    [[nodiscard]] bool blockBegins(const Value& v) const;
    void reportNone(const Value& v, std::string_view key, TextRange keyRange, TextRange equals);
    void wordElement(Element& e);
    void numberElement(Element& e, Value& v);
    void stringElement(Element& e, Value& v);
    void openString(Element& e);
    void stringOfLines(Element& e, std::size_t quote);
    bool afterElement(Value& v, std::vector<TextRange>& gaps);
    [[nodiscard]] bool openBracket() const;
    [[nodiscard]] std::size_t termInParens() const;
    [[nodiscard]] bool keyFollows(const Value& v, bool gaps) const;

    ExpressionParser m_expressions;
    ValueErrors m_errors;
    bool m_mayBeDescribed = false; ///< a word before `{` is a value
    std::size_t m_keyAt = static_cast<std::size_t>(-1);
};

} // namespace trundle
