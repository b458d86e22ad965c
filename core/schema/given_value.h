#pragma once
// A value as written, after evaluation of Params and expressions.

#include <cstdint>
#include <string>
#include <vector>

#include "base/source_range.h"

namespace trundle {

struct GivenElement {
    enum class Kind { Number, Word, String, Boolean };
    Kind kind = Kind::Word;
    double number = 0;
    bool boolean = false;
    std::string text;      ///< the word or the unescaped string
    std::string unit;      ///< empty: none
    SourceRange range;     ///< where it is in the text (`$name` for a Param)
    SourceRange unitRange; ///< empty if there is no unit
    SourceRange source;    ///< range of the value itself where it comes from a Param
    bool literal = true;   ///< written literally in the text, so that a fix may rewrite it
    /// How many Parts further out it was written: a name in it is looked up there.
    std::uint32_t level = 0;
};

struct GivenValue {
    std::vector<GivenElement> elements;
    SourceRange range; ///< of the whole value
    bool fromParam = false;
};

} // namespace trundle
