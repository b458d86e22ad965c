#pragma once
// Converts the elements of a value, as written, into the value of a property: converts units, checks ranges and reports errors.

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "schema/kind.h"

namespace trundle {

/// One element of a value after evaluation of Params and expressions.
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
};

struct GivenValue {
    std::vector<GivenElement> elements;
    SourceRange range; ///< of the whole value
    bool fromParam = false;
};

/// The note on an error in a value that comes from a Param; it refers to the value itself.
inline constexpr const char* kGivenHere = "the value is given here";

/// The value of the property; empty after reporting what is wrong (E202-E207). The name of a reference is not resolved here.
[[nodiscard]] std::optional<PropertyValue> readValue(const Property& property, const GivenValue& given, Diagnostics& diagnostics);

} // namespace trundle
