#pragma once
// Diagnostics for common mistakes in values: other number notations, other quotes, missing commas, arithmetic outside `$( )`. One
// message each, with a fix where it is obvious. Private to core/lang.

#include <functional>

#include "lang/parsing/arithmetic_errors.h"
#include "lang/parsing/path_errors.h"
#include "lang/parsing/unit_errors.h"

namespace trundle {

class ValueErrors : ParserPart {
public:
    /// `element` parses one element of a value.
    ValueErrors(TokenCursor& tokens, SyntaxReporter& report, std::function<bool(Value&)> element)
        : ParserPart(tokens, report), m_units(tokens, report), m_arithmetic(tokens, report), m_paths(tokens, report),
          m_element(std::move(element)) {}

    /// Reports a suffix that looks like a unit but belongs to a number in another notation.
    void checkNumberTail(Element& e, Value& v);
    /// `- 3`, `-$x`, `-$(a)`, `-word`: a sign separated from its number.
    void signedElement(Element& e, Value& v);
    /// Reports an element followed by unexpected text: `2*0.05` continues as arithmetic, `robot0@x` and `3d.png` as text.
    void continuesAt(Element& e, Value& v);
    /// 'text', or text in the typographic quotes of word processors.
    void foreignQuotes(Element& e, Value& v);
    /// `${name}` of a shell, `${2 * name}` of xacro.
    void bracedParam(Element& e, Value& v);
    /// `{{name}}`.
    void doubleBraces(Element& e, Value& v);
    /// `$ name`.
    void spacedParam(Element& e, Value& v);
    bool unitBehindParam(const Element& e) { return m_units.behindParam(e); }
    void unitWithoutPower(Element& e) { m_units.withoutPower(e); }
    /// Text without spaces that is not a word: `../x.csv`, `3d.png`, `C:\maps`, `#ff0000`.
    void unquotedText(Element& e, Value& v);
    void arithmetic(Element& e, Value& v) { m_arithmetic.arithmetic(e, v); }
    /// `key`: of the value. Text in words is offered in quotes first, what else is offered as a list first.
    void reportGaps(Value& v, const std::vector<TextRange>& gaps, std::string_view key);
    /// `[1,2,3]`, `(1,2,3)`, `{1,2,3}`: the elements have been parsed, the closing bracket has not.
    void reportBrackets(Value& v, TextRange bracket, const std::vector<TextRange>& gaps);
    /// `()`, whose value is reported as missing.
    void skipBrackets(TextRange bracket);

private:
    [[nodiscard]] bool closes(TextRange bracket) const;
    [[nodiscard]] bool skipRest(std::vector<TextEdit>& edits);
    void reportUnquoted(const Element& e, const std::string& written);

    UnitErrors m_units;
    ArithmeticErrors m_arithmetic;
    PathErrors m_paths;
    std::function<bool(Value&)> m_element;
};

} // namespace trundle
