#pragma once
// Parses `#import` and `#loadModule`. Private to core/lang.

#include "lang/parsing/parser_part.h"

namespace trundle {

class DirectiveParser : ParserPart {
public:
    DirectiveParser(TokenCursor& tokens, SyntaxReporter& report) : ParserPart(tokens, report) {}

    void directive(std::vector<Item>& out);

private:
    [[nodiscard]] std::pair<std::string, TextRange> path(TextRange directive, std::size_t reported);
};

} // namespace trundle
