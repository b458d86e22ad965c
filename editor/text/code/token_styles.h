#pragma once
// Syntax highlighting and folding of a text, from the tokens of the language's own lexer.

#include <string>
#include <string_view>
#include <vector>

#include "lang/token.h"

namespace trundle {

enum class TextStyle : char {
    Plain,
    Kind,
    Name, ///< of a block or a Param, in its definition
    Key,
    Keyword, ///< Param, true, false, functions
    Number,
    Unit,
    Word, ///< a value: a reference, a choice, a file
    String,
    Param, ///< a use of a Param
    Comment,
    Directive,
    Path,
    Mark, ///< braces, equals signs, commas
    Wrong,
    Count
};

/// One style per byte of the text. The tokens are those of the whole text.
[[nodiscard]] std::string stylesOf(std::string_view text, const std::vector<Token>& tokens);

/// One line: the number of blocks open at its start, and whether it opens one that ends on a later line.
struct FoldLine {
    int level = 0;
    bool opens = false;
    bool operator==(const FoldLine&) const = default;
};
/// One entry per line (ended by LF, CR LF or a lone CR). Multi-line comments fold like blocks.
[[nodiscard]] std::vector<FoldLine> foldLinesOf(std::string_view text, const std::vector<Token>& tokens);

} // namespace trundle
