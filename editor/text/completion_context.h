#pragma once
// Where in its statement a caret stands, by the tokens before it. Private to completion.

#include <optional>
#include <string>
#include <vector>

#include "lang/tree.h"

namespace trundle {

struct CompletionContext {
    enum class Where {
        Nowhere,       ///< a comment, a text in quotes, the name of a block
        DirectiveName, ///< `#im|`
        Import,
        Module,
        Statement,  ///< a key, a kind, Param
        Override,   ///< `leftMotor.|`: path holds what stands before the last dot
        Value,      ///< path holds the key
        Number,     ///< behind a number of a value: a unit, or, with a blank between, the next statement
        Expression, ///< in `$( )`
        ParamUse,   ///< behind `$`
    };
    Where where = Where::Nowhere;
    TextRange word;                ///< typed of it already
    std::vector<std::string> path; ///< of the key
    std::string before;            ///< of a value with dots, what stands before `word`: "chassis."
    bool ofParam = false;          ///< the value of a Param
    bool blank = false;            ///< a blank stands before `word`
    bool quoted = false;           ///< inside quotes
};

[[nodiscard]] CompletionContext completionContext(const Tree& tree, std::uint32_t offset);

} // namespace trundle
