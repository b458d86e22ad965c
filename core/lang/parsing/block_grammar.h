#pragma once
// What parts of the parser ask of the one that parses blocks. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

/// What a mistake is parsed as once it has been reported.
class BlockGrammar {
public:
    /// `Type {`, with `extra` tokens before the brace: a name, or unexpected tokens that were already reported.
    virtual void block(std::vector<Item>& out, int depth, std::size_t extra) = 0;
    virtual void blockBody(BlockItem& block, int depth) = 0;
    /// `Param name = value`, with whatever word in place of `Param`.
    virtual void param(std::vector<Item>& out, int depth) = 0;
    /// Skips to the `}` of a block whose `{` has been consumed, without parsing its content.
    virtual void skipBlockBody() = 0;
    [[nodiscard]] virtual Value value(std::string_view key, TextRange keyRange, TextRange equals) = 0;
    virtual void rejectReserved(const Name& name, std::string_view use) = 0;

protected:
    ~BlockGrammar() = default;
};

} // namespace trundle
