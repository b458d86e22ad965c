#include "lang/edit_style.h"

#include <algorithm>

#include "lang/characters.h"

namespace trundle {
namespace {

/// Counts the assignments directly in `items`: those with a space before `=` minus those without.
int countSpaced(const Tree& tree, const std::vector<Item>& items) {
    const std::string_view bytes = tree.source().bytes();
    int spaced = 0;
    for (const Item& item : items) {
        const auto* assignment = item.as<AssignmentItem>();
        if (assignment && assignment->pathRange.end < bytes.size()) spaced += isBlank(bytes[assignment->pathRange.end]) ? 1 : -1;
    }
    return spaced;
}

/// The same; if the count is zero, includes the blocks nested in `items`.
int countSpacedInside(const Tree& tree, const std::vector<Item>& items) {
    int spaced = countSpaced(tree, items);
    if (spaced != 0) return spaced;
    for (const Item& item : items)
        if (const auto* block = item.as<BlockItem>()) spaced += countSpacedInside(tree, block->items);
    return spaced;
}

} // namespace

std::string indentOfLine(std::string_view bytes, std::uint32_t offset) {
    std::uint32_t start = offset;
    while (start > 0 && bytes[start - 1] != '\n' && bytes[start - 1] != '\r') --start;
    if (start == 0 && bytes.starts_with("\xEF\xBB\xBF")) start = 3;
    std::uint32_t end = start;
    while (end < bytes.size() && isBlank(bytes[end])) ++end;
    return std::string(bytes.substr(start, end - start));
}

EditStyle editStyle(const Tree& tree) {
    EditStyle style;
    const std::string_view bytes = tree.source().bytes();
    const auto& tokens = tree.tokens();
    const auto lineEnd = std::find_if(tokens.begin(), tokens.end(), [](const Token& t) { return t.kind == TokenKind::LineEnd; });
    if (lineEnd != tokens.end()) style.lineEnd = tree.source().slice(lineEnd->range);

    // The indent of the first item that starts a line inside a block that starts a line.
    for (const Item& item : tree.items()) {
        const auto* block = item.as<BlockItem>();
        if (!block) continue;
        const std::string outer = indentOfLine(bytes, item.range.begin);
        constexpr std::ptrdiff_t kFar = 1000; // items; one that long without any is not searched to its end for each edit
        const auto last = block->items.begin() + std::min(kFar, std::ssize(block->items));
        const auto inner = std::find_if(block->items.begin(), last, [&](const Item& i) {
            const std::string indent = indentOfLine(bytes, i.range.begin);
            const std::uint32_t start = tree.source().position(i.range.begin).line;
            return start != tree.source().position(item.range.begin).line && indent.size() > outer.size() &&
                   indent.starts_with(outer);
        });
        if (inner == last) continue;
        style.step = indentOfLine(bytes, inner->range.begin).substr(outer.size());
        break;
    }
    const int spaced = countSpacedInside(tree, tree.items());
    style.spacedEquals = spaced >= 0;
    return style;
}

bool spacedEquals(const Tree& tree, const BlockItem* block, const EditStyle& style) {
    const int spaced = countSpacedInside(tree, block ? block->items : tree.items());
    return spaced == 0 ? style.spacedEquals : spaced > 0;
}

} // namespace trundle
