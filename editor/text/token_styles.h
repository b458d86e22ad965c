#pragma once
// What each byte of a text looks like and where its lines fold, from the tokens of the language's own lexer.

#include <string>
#include <string_view>
#include <vector>

#include "lang/token.h"

namespace trundle {

enum class TextStyle : char {
    Plain,
    Kind,
    Name, ///< of a block or a Param, where it is given
    Key,
    Keyword, ///< Param, true, false, functions
    Number,
    Unit,
    Word, ///< a value: a reference, a choice, a file
    String,
    Param, ///< where one is used
    Comment,
    Directive,
    Path,
    Mark, ///< braces, equals signs, commas
    Wrong,
    Count
};

/// One style for each byte, as many as the text has. The tokens are those of the whole text.
[[nodiscard]] std::string stylesOf(std::string_view text, const std::vector<Token>& tokens);

/// One line: how many blocks are open where it begins, and whether it opens one that ends on a later line.
struct FoldLine {
    int level = 0;
    bool opens = false;
    bool operator==(const FoldLine&) const = default;
};
/// As many as the text has lines (ended by LF, CR LF or a lone CR). Comments over several lines fold as blocks do.
[[nodiscard]] std::vector<FoldLine> foldLinesOf(std::string_view text, const std::vector<Token>& tokens);

} // namespace trundle
