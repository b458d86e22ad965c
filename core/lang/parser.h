#pragma once
// Converts a text to a tree, with error recovery. Method: recursive descent over the tokens that are not trivia; unreadable text is
// reported once, where it can be corrected, and skipped up to the next key, brace or line.
// Promises: every loop consumes a token; blocks and expressions have a maximum depth; the number of diagnostics is bounded.
// Parts: TokenCursor reads tokens, ItemParser and what it holds turn them into items, BraceBalance finds missing braces, TextChecks
// checks what the grammar skips; all report to one SyntaxReporter.

#include "lang/parsing/item_parser.h"
#include "lang/parsing/text_checks.h"

namespace trundle {

class Parser {
public:
    Parser(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens);
    [[nodiscard]] std::shared_ptr<const Tree> parse();

private:
    void run();

    std::shared_ptr<Tree> m_tree;
    SyntaxReporter m_report;
    TokenCursor m_tokens;
    BraceBalance m_balance;
    TextChecks m_checks;
    ItemParser m_items;
};

} // namespace trundle
