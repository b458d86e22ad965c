#pragma once
// From the elements of a value, as written, to what a property holds: units converted, ranges checked, faults explained.

#include <optional>
#include <string>
#include <vector>

#include "base/diagnostic.h"
#include "schema/kind.h"

namespace trundle {

/// One element of a value once its Params and expressions are worked out.
struct GivenElement {
    enum class Kind { Number, Word, String, Boolean };
    Kind kind = Kind::Word;
    double number = 0;
    bool boolean = false;
    std::string text;      ///< the word or the unescaped string
    std::string unit;      ///< empty: none
    SourceRange range;     ///< where it stands in the text (`$name` for a Param)
    SourceRange unitRange; ///< empty where the unit does not stand there
    SourceRange source;    ///< where the value itself stands when a Param brought it
    bool literal = true;   ///< stands in the text as such, so that a fix may rewrite it
};

struct GivenValue {
    std::vector<GivenElement> elements;
    SourceRange range; ///< of the whole value
    bool fromParam = false;
};

/// The note on a fault whose value a Param brought: the place of the value itself.
inline constexpr const char* kGivenHere = "the value is given here";

/// What the property holds, or nothing after saying what is wrong: E202-E207. The name of a reference is not looked up here.
[[nodiscard]] std::optional<PropertyValue> readValue(const Property& property, const GivenValue& given, Diagnostics& diagnostics);

} // namespace trundle
