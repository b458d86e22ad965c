#pragma once
// Diagnostics for configs with Params as other languages write them: one message each. What they declare is there nonetheless, so that
// its uses are no mistakes. Private to core/lang.

#include "lang/parsing/block_grammar.h"

namespace trundle {

class ForeignConfigs : ParserPart {
public:
    ForeignConfigs(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar)
        : ParserPart(tokens, report), m_grammar(grammar) {}

    // Each reports what begins here and returns true, or returns false.
    [[nodiscard]] bool params(std::vector<Item>& out,
                              int depth); ///< `PartConfig Wheel(r=0.05, paint) {`, `PartConfig Wheel r=0.05 {`
    [[nodiscard]] bool group(std::vector<Item>& out, int depth); ///< `Params { r = 0.05 }`
    [[nodiscard]] bool proto(std::vector<Item>& out);            ///< `PROTO Wheel [ field SFFloat r 0.05 ] { ... }`

private:
    [[nodiscard]] bool readParams(std::size_t brace, std::vector<Item>& declared, std::string& meant) const;
    [[nodiscard]] std::size_t endOfValue(std::size_t from, std::size_t end) const;

    BlockGrammar& m_grammar;
};

} // namespace trundle
