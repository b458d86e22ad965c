#pragma once
// Parses items: assignments, Params, blocks and directives. Private to core/lang.

#include "lang/parsing/brace_balance.h"
#include "lang/parsing/directive_parser.h"
#include "lang/parsing/item_errors.h"
#include "lang/parsing/other_languages.h"
#include "lang/parsing/param_errors.h"
#include "lang/parsing/path_errors.h"
#include "lang/parsing/value_parser.h"

namespace trundle {

class ItemParser final : ParserPart, BlockGrammar {
public:
    ItemParser(TokenCursor& tokens, SyntaxReporter& report, BraceBalance& balance)
        : ParserPart(tokens, report), m_balance(balance), m_values(tokens, report), m_directives(tokens, report),
          m_errors(tokens, report, *this, balance), m_paramErrors(tokens, report, *this), m_pathErrors(tokens, report),
          m_otherLanguages(tokens, report, *this, balance) {}
    ItemParser(const ItemParser&) = delete;
    ItemParser& operator=(const ItemParser&) = delete;

    /// The items of a text (depth 0) or of the innermost open block.
    void items(std::vector<Item>& out, int depth);

private:
    void block(std::vector<Item>& out, int depth, std::size_t extra) override;
    void blockBody(BlockItem& block, int depth) override;
    void skipBlockBody() override;
    [[nodiscard]] Value value(std::string_view key, TextRange keyRange, TextRange equals) override {
        return m_values.value(key, keyRange, equals);
    }
    void rejectReserved(const Name& name, std::string_view use) override;
    void item(std::vector<Item>& out, int depth);
    void assignment(std::vector<Item>& out);
    void param(std::vector<Item>& out, int depth) override;
    void description(ParamItem& param, int indent, int depth);
    void openBracket(OpenBlock& open, const char* what);
    void bodyOf(const OpenBlock& open, BlockItem& node, int depth);

    BraceBalance& m_balance;
    ValueParser m_values;
    DirectiveParser m_directives;
    ItemErrors m_errors;
    ParamErrors m_paramErrors;
    PathErrors m_pathErrors;
    OtherLanguages m_otherLanguages;
};

} // namespace trundle
