#pragma once
// Diagnostics for what other languages say and this one says differently: one message each, with how it is said here. Private to
// core/lang.

#include "lang/parsing/item_errors.h"

namespace trundle {

class OtherLanguages : ParserPart {
public:
    OtherLanguages(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar)
        : ParserPart(tokens, report), m_grammar(grammar) {}

    /// Reports and parses what begins here and looks like an item of ours, but is none; false if it is nothing known.
    [[nodiscard]] bool misread(std::vector<Item>& out, int depth) { return definition() || nameFirst(out, depth); }
    /// Reports and parses what begins here and is no item of ours; false if it is nothing known.
    [[nodiscard]] bool explain(std::vector<Item>& out, int depth) {
        return loop() || inheritance(out, depth) || computedName(out, depth) || count(out, depth) || nameInParens(out, depth) ||
               importWithoutSign();
    }
    /// `-- text` and `% text` on a line of their own.
    [[nodiscard]] bool comment();
    /// `<link name="a">` and the tags that follow it.
    [[nodiscard]] bool markup();

private:
    [[nodiscard]] bool loop();
    [[nodiscard]] bool array();
    void otherwise();
    [[nodiscard]] bool definition();
    [[nodiscard]] bool nameFirst(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameInParens(std::vector<Item>& out, int depth);
    void configFirst(std::vector<Item>& out, int depth);
    [[nodiscard]] bool configCalled(std::vector<Item>& out);
    [[nodiscard]] bool otherCount();
    [[nodiscard]] bool count(std::vector<Item>& out, int depth);
    [[nodiscard]] bool importWithoutSign();
    void blockWith(std::vector<Item>& out, int depth, std::size_t extra, Item item);
    [[nodiscard]] bool inheritance(std::vector<Item>& out, int depth);
    [[nodiscard]] bool computedName(std::vector<Item>& out, int depth);
    [[nodiscard]] std::size_t braceInLine() const;

    BlockGrammar& m_grammar;
};

} // namespace trundle
