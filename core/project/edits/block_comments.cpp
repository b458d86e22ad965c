#include "project/edits/block_comments.h"

#include <algorithm>

#include "lang/characters.h"
#include "lang/tree_edit.h"

namespace trundle {

namespace {

bool isBlankOrComment(const Token& token) {
    return token.kind == TokenKind::Space || token.kind == TokenKind::LineComment || token.kind == TokenKind::BlockComment;
}

bool beginsLine(std::string_view bytes, std::uint32_t at) {
    while (at > 0 && isBlank(bytes[at - 1])) --at;
    return at == 0 || bytes[at - 1] == '\n' || bytes[at - 1] == '\r';
}

/// Whether only chosen items follow, up to a blank line, a comment, an item of another kind or the end of the block around.
bool endsItsGroup(const Tree& tree, TextRange item, const std::vector<SourceRange>& chosen) {
    const auto& tokens = tree.tokens();
    const auto from = [&](std::uint32_t at) {
        return std::ranges::lower_bound(tokens, at, {}, [](const Token& t) { return t.range.begin; });
    };
    const auto first = from(item.begin);
    const std::string_view kind = first == tokens.end() ? std::string_view() : tree.source().slice(first->range);
    int lineEnds = 0; // since the last item
    for (auto it = from(item.end); it != tokens.end(); ++it) {
        if (it->kind == TokenKind::Space) continue;
        if (it->kind == TokenKind::LineEnd) {
            if (++lineEnds == 2) return true;
            continue;
        }
        if (isBlankOrComment(*it)) {
            if (lineEnds > 0) return true;
            continue;
        }
        const auto next = std::ranges::find_if(
            chosen, [&](const SourceRange& c) { return c.file == tree.file() && c.range.begin == it->range.begin; });
        if (next == chosen.end()) return tree.source().slice(it->range) != kind;
        it = std::prev(from(next->range.end));
        lineEnds = 0;
    }
    return true;
}

} // namespace

std::uint32_t commentAbove(const Tree& tree, std::uint32_t at) {
    const std::string_view bytes = tree.source().bytes();
    if (!beginsLine(bytes, at)) return at;
    std::uint32_t start = at;
    while (start > 0 && isBlank(bytes[start - 1])) --start;
    const auto& tokens = tree.tokens();
    auto it = std::ranges::lower_bound(tokens, start, {}, [](const Token& token) { return token.range.begin; });
    while (it != tokens.begin() && (--it)->kind == TokenKind::LineEnd) {
        bool isComment = false; // the line above has nothing else
        for (; it != tokens.begin() && isBlankOrComment(*std::prev(it)); --it)
            isComment |= std::prev(it)->kind != TokenKind::Space;
        if (!isComment || (it != tokens.begin() && std::prev(it)->kind != TokenKind::LineEnd)) break;
        start = it->range.begin;
    }
    return start;
}

std::optional<std::uint32_t> endOfLineBehind(const Tree& tree, std::uint32_t offset) {
    const std::string_view bytes = tree.source().bytes();
    const std::uint32_t end = behindComments(tree, offset);
    std::size_t next = end;
    while (next < bytes.size() && isBlank(bytes[next])) ++next;
    const bool ends = next == bytes.size() || bytes[next] == '\n' || bytes[next] == '\r';
    return ends ? std::optional(end) : std::nullopt;
}

SourceRange withComment(const LoadedProject& loaded, SourceRange item) {
    const Tree& tree = *loaded.trees[item.file];
    const std::string_view bytes = tree.source().bytes();
    if (!beginsLine(bytes, item.range.begin)) return item;
    item.range.end = endOfLineBehind(tree, item.range.end).value_or(item.range.end);
    return item;
}

SourceRange withComments(const LoadedProject& loaded, SourceRange item) {
    const Tree& tree = *loaded.trees[item.file];
    SourceRange whole = withComment(loaded, item);
    whole.range.begin = commentAbove(tree, item.range.begin);
    while (isBlank(tree.source().bytes()[whole.range.begin])) ++whole.range.begin;
    return whole;
}

SourceRange withOwnComments(const LoadedProject& loaded, SourceRange item, const std::vector<SourceRange>& chosen) {
    const SourceRange whole = withComments(loaded, item);
    const Tree& tree = *loaded.trees[item.file];
    const std::uint32_t fileBegin = tree.source().bytes().starts_with("\xEF\xBB\xBF") ? 3 : 0;
    const bool own = whole.range.begin > fileBegin && endsItsGroup(tree, item.range, chosen);
    return own ? whole : withComment(loaded, item);
}

} // namespace trundle
