#pragma once
// Checks of a text that the grammar does not make: its encoding, characters that cannot be seen, words that are too long, a comment
// without an end. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

class TextChecks : ParserPart {
public:
    TextChecks(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    [[nodiscard]] bool isUtf16() const;
    /// Whether it is a file of another language, such as XML or JSON; then it is reported, and nothing else in it.
    [[nodiscard]] bool isOtherLanguage();
    /// Reports NUL and invalid UTF-8 everywhere, including comments: one message per run, at its first byte.
    void checkBytes();
    /// After all tokens were read.
    void checkTokens();

private:
    void checkInvisible();
    void checkLongWords();
    void checkComments();
};

} // namespace trundle
