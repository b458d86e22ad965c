#pragma once
// Diagnostics for what other languages say and this one says differently: one message each, with how it is said here. Private to
// core/lang.

#include "lang/parsing/control_flow.h"
#include "lang/parsing/data_formats.h"
#include "lang/parsing/foreign_configs.h"

namespace trundle {

class OtherLanguages : ParserPart {
public:
    OtherLanguages(TokenCursor& tokens, SyntaxReporter& report, BlockGrammar& grammar, const BraceBalance& balance)
        : ParserPart(tokens, report), m_grammar(grammar), m_flow(tokens, report, grammar, balance),
          m_formats(tokens, report, grammar, balance, m_flow), m_configs(tokens, report, grammar) {}

    /// Reports and parses what begins here and looks like an item, but is said otherwise here; false for all else.
    [[nodiscard]] bool misread(std::vector<Item>& out, int depth) {
        return m_flow.definition() || m_configs.proto(out) || m_configs.group(out, depth) || m_formats.block(out, depth) ||
               nameFirst(out, depth);
    }
    /// Reports and parses what begins here and is no item of ours; false if it is nothing known.
    [[nodiscard]] bool explain(std::vector<Item>& out, int depth) {
        return m_flow.loop() || m_configs.params(out, depth) || inheritance(out, depth) || computedName(out, depth) ||
               count(out, depth) || nameInParens(out, depth) || importWithoutSign();
    }
    /// The same for what begins with no word.
    [[nodiscard]] bool explainSign() { return comment() || markup() || m_flow.markup() || m_formats.data(); }
    /// `Body $side {`, `Body wheel_$i {`, `Body wheel$(i) {`.
    [[nodiscard]] bool computedName(std::vector<Item>& out, int depth);

private:
    [[nodiscard]] bool comment();
    [[nodiscard]] bool markup();
    [[nodiscard]] bool nameFirst(std::vector<Item>& out, int depth);
    [[nodiscard]] bool nameInParens(std::vector<Item>& out, int depth);
    void configFirst(std::vector<Item>& out, int depth);
    [[nodiscard]] bool configCalled(std::vector<Item>& out);
    [[nodiscard]] bool otherCount();
    [[nodiscard]] bool count(std::vector<Item>& out, int depth);
    [[nodiscard]] bool importWithoutSign();
    void blockWith(std::vector<Item>& out, int depth, std::size_t extra, Item item);
    [[nodiscard]] bool inheritance(std::vector<Item>& out, int depth);

    BlockGrammar& m_grammar;
    ControlFlow m_flow;
    DataFormats m_formats;
    ForeignConfigs m_configs;
};

} // namespace trundle
