#pragma once
// Diagnostics for paths that are written otherwise, as `m[0].q` and `left/rim`: one message each, with its fix. Private to core/lang.

#include <optional>
#include <unordered_set>

#include "lang/parsing/parser_part.h"

namespace trundle {

class PathErrors : ParserPart {
public:
    PathErrors(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    /// Reports the path that is the current word and adds its names; false if it is written as here.
    [[nodiscard]] bool names(std::vector<Name>& out);
    /// `left::axle`, `m[0].axle` as an element; false if it is no path.
    [[nodiscard]] bool element(const Element& e, std::string_view written);
    /// `m_$i`, `m_$(index-1).a`: the rest of an element that is computed in part; false if it does not continue so.
    [[nodiscard]] bool computed(Element& e, Value& v);
    /// `$left.axle`; false if the element does not continue so.
    [[nodiscard]] bool behindParam(Element& e, Value& v);

private:
    void skipRest();
    [[nodiscard]] bool isParam(const std::string& name);

    std::optional<std::unordered_set<std::string>> m_params; ///< of the whole text, as soon as one is asked for
};

} // namespace trundle
