#pragma once
// Diagnostics for units that are written otherwise: one message each, with its fix. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

class UnitErrors : ParserPart {
public:
    UnitErrors(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    /// `m/s2`, `cm3`.
    void withoutPower(Element& e);
    /// Reads the pieces of a unit behind the first; false if they form none.
    [[nodiscard]] bool inPieces(Element& e);

    /// `$r cm`, `$(2*r) cm`: reads the unit; false if none is there.
    bool behindParam(const Element& e);

private:
    [[nodiscard]] std::size_t pieceAt(std::size_t ahead, std::string& written) const;
};

} // namespace trundle
