#pragma once
// Diagnostics for blocks as JSON, YAML, VRML and calls of programming languages have them: one message each. Private to core/lang.

#include "lang/parsing/block_grammar.h"

namespace trundle {

class BraceBalance;
class ControlFlow;

class DataFormats : ParserPart {
public:
    DataFormats(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, const BraceBalance& balance,
                ControlFlow& flow)
        : ParserPart(tokens, report), m_grammar(grammar), m_balance(balance), m_flow(flow) {}

    // Each reports what begins here and returns true, or returns false.
    [[nodiscard]] bool block(std::vector<Item>& out, int depth) { // that begins with a word
        return namedByDef(out, depth) || called(out, depth) || nested(out, depth) || children();
    }
    [[nodiscard]] bool data() { return json() || yaml(); } ///< that begins with no word

private:
    [[nodiscard]] bool namedByDef(std::vector<Item>& out, int depth);
    [[nodiscard]] bool called(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nested(std::vector<Item>& out, int depth);
    [[nodiscard]] bool children();
    [[nodiscard]] bool json();
    [[nodiscard]] bool yaml();
    [[nodiscard]] std::vector<TextEdit> repairedCall() const;
    void swappedBlock(std::vector<Item>& out, int depth, std::size_t extra, const Name& type, const Name& own);
    void skipBrackets();

    BlockGrammar& m_grammar;
    const BraceBalance& m_balance;
    ControlFlow& m_flow;
};

} // namespace trundle
