#pragma once
// Diagnostics for what other languages say and this one says differently: one message each, with how it is said here. Private to
// core/lang.

#include "lang/parsing/item_errors.h"

namespace trundle {

class OtherLanguages : ParserPart {
public:
    OtherLanguages(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar)
        : ParserPart(tokens, report), m_grammar(grammar) {}

    /// Reports and parses what begins here; false if it is nothing known.
    [[nodiscard]] bool explain(std::vector<Item>& out, int depth) {
        return loop() || inheritance(out, depth) || computedName(out, depth) || count(out, depth) || importWithoutSign();
    }
    /// `-- text` and `% text` on a line of their own.
    [[nodiscard]] bool comment();

private:
    [[nodiscard]] bool loop();
    void otherwise();
    [[nodiscard]] bool count(std::vector<Item>& out, int depth);
    [[nodiscard]] bool importWithoutSign();
    void blockWith(std::vector<Item>& out, int depth, std::size_t extra, std::string key, Element value);
    [[nodiscard]] bool inheritance(std::vector<Item>& out, int depth);
    [[nodiscard]] bool computedName(std::vector<Item>& out, int depth);
    [[nodiscard]] std::size_t braceInLine() const;

    BlockGrammar& m_grammar;
};

} // namespace trundle
