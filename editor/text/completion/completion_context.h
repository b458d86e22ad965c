#pragma once
// Determines from the tokens before the caret where in a statement it is. Private to completion.

#include <optional>
#include <string>
#include <vector>

#include "lang/tree.h"

namespace trundle {

struct CompletionContext {
    enum class Where {
        Nowhere,       ///< in a comment, a quoted text or the name of a block
        DirectiveName, ///< `#im|`
        Import,
        Module,
        Statement,  ///< a key, a kind, Param
        Override,   ///< `leftMotor.|`: path has the components before the last dot
        Value,      ///< path is the key
        Number,     ///< after a number in a value: a unit or, after a blank, the next statement
        Expression, ///< inside `$( )`
        ParamUse,   ///< after `$`
    };
    Where where = Where::Nowhere;
    TextRange word;                ///< the part typed so far
    std::vector<std::string> path; ///< of the key
    std::string before;            ///< in a dotted value, the text before `word`: "chassis."
    bool ofParam = false;          ///< the value of a Param
    bool blank = false;            ///< `word` is preceded by a blank
    bool quoted = false;           ///< inside quotes
};

[[nodiscard]] CompletionContext completionContext(const Tree& tree, std::uint32_t offset);

} // namespace trundle
