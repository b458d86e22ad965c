#include "lang/tree.h"

#include "lang/parser.h"

namespace trundle {

std::shared_ptr<const Tree> parse(std::shared_ptr<const SourceText> source, FileId file, std::size_t mostTokens) {
    return Parser(std::move(source), file, mostTokens).parse();
}

std::string print(const Tree& tree) {
    std::string text;
    text.reserve(tree.source().bytes().size());
    for (const Token& token : tree.tokens()) text += tree.source().slice(token.range);
    return text;
}

} // namespace trundle
