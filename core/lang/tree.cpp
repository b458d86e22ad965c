#include "lang/tree.h"

namespace trundle {

std::string print(const Tree& tree) {
    std::string text;
    text.reserve(tree.source().bytes().size());
    for (const Token& token : tree.tokens()) text += tree.source().slice(token.range);
    return text;
}

} // namespace trundle
