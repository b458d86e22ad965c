// Edits as byte splices. Needs: a tree and the position of an edit. Result: the smallest change of bytes that performs it, in the
// style of the file: line ends, indent, spaces around `=`. Text outside the edit is not reformatted.

#include "lang/tree_edit.h"

#include <algorithm>
#include <optional>

#include "base/units.h"
#include "lang/characters.h"
#include "lang/edit_style.h"

namespace trundle {

std::uint32_t behindComments(const Tree& tree, std::uint32_t from) {
    const auto& tokens = tree.tokens();
    auto token = std::lower_bound(tokens.begin(), tokens.end(), from,
                                  [](const Token& t, std::uint32_t offset) { return t.range.begin < offset; });
    std::uint32_t end = from;
    for (; token != tokens.end() && isTrivia(token->kind) && token->kind != TokenKind::LineEnd; ++token)
        if (token->kind == TokenKind::LineComment || token->kind == TokenKind::BlockComment) end = token->range.end;
    return end;
}
namespace {

TextEdit at(const Tree& tree, std::uint32_t begin, std::uint32_t end, std::string text) {
    return {{tree.file(), {begin, end}}, std::move(text)};
}

std::uint32_t lineStart(std::string_view bytes, std::uint32_t from) {
    while (from > 0 && bytes[from - 1] != '\n' && bytes[from - 1] != '\r') --from;
    return from;
}

std::uint32_t blanksAfter(std::string_view bytes, std::uint32_t from) {
    while (from < bytes.size() && isBlank(bytes[from])) ++from;
    return from;
}

std::uint32_t blanksBefore(std::string_view bytes, std::uint32_t from) {
    while (from > 0 && isBlank(bytes[from - 1])) --from;
    return from;
}

bool isLineEnd(std::string_view bytes, std::uint32_t at) { return at >= bytes.size() || bytes[at] == '\n' || bytes[at] == '\r'; }

std::uint32_t afterLineEnd(std::string_view bytes, std::uint32_t at) {
    if (at >= bytes.size()) return at;
    return at + (bytes[at] == '\r' && at + 1 < bytes.size() && bytes[at + 1] == '\n' ? 2 : 1);
}

bool hasLineEnd(std::string_view text) { return text.find_first_of("\r\n") != std::string_view::npos; }

/// The lines of `text` after `indent`, with the file's line ends. If the text ends with a closing brace on a line of its own,
/// that brace is aligned with the indent, and all lines after the first are shifted left by the same amount.
std::string reindent(std::string_view text, const std::string& indent, const std::string& lineEnd) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
        lines.push_back(text.substr(0, end));
        text.remove_prefix(end < text.size() ? afterLineEnd(text, static_cast<std::uint32_t>(end)) : end);
    }
    std::size_t last = 0, common = std::string_view::npos; // of the last line if it is a `}`; smallest of all lines but the first
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::size_t first = lines[i].find_first_not_of(" \t");
        if (first == std::string_view::npos) continue;
        common = std::min(common, first);
        last = lines[i][first] == '}' ? first : 0;
    }
    common = std::min(common, last);
    std::string out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        std::string_view line = lines[i];
        const std::size_t first = line.find_first_not_of(" \t");
        line.remove_prefix(i == 0                            ? std::min(first, line.size())
                           : first == std::string_view::npos ? line.size()
                                                             : std::min(common, line.size()));
        if (i > 0) out += lineEnd;
        if (!line.empty()) out += indent + std::string(line);
    }
    return out;
}

/// Where a new last item of a block or file is inserted: after `after`, on a new line or on the same one.
struct Slot {
    std::uint32_t place = 0;
    std::uint32_t end = 0; ///< spaces up to this offset are replaced; 0: none
    std::string before, behind, indent;
    bool ownLine = true;
};

bool containsLineComment(const Tree& tree, std::uint32_t from, std::uint32_t to) {
    const auto& tokens = tree.tokens();
    auto token = std::lower_bound(tokens.begin(), tokens.end(), from,
                                  [](const Token& t, std::uint32_t offset) { return t.range.begin < offset; });
    for (; token != tokens.end() && token->range.begin < to; ++token)
        if (token->kind == TokenKind::LineComment) return true;
    return false;
}

Slot slotInFile(const Tree& tree, const EditStyle& style) {
    const auto bytes = tree.source().bytes();
    const auto size = static_cast<std::uint32_t>(bytes.size());
    Slot slot;
    slot.place = size;
    const std::uint32_t line = lineStart(bytes, size);
    const bool onlyBom = bytes == std::string_view("\xEF\xBB\xBF");
    if (line < size && !onlyBom) slot.before = style.lineEnd;
    slot.behind = style.lineEnd;
    return slot;
}

Slot slotInBlock(const Tree& tree, const BlockItem& block, std::uint32_t blockBegin, const EditStyle& style) {
    const auto bytes = tree.source().bytes();
    const bool oneLine = !hasLineEnd(bytes.substr(block.open.end, block.close.begin - block.open.end));
    const std::string outer = indentOfLine(bytes, blockBegin);
    Slot slot;
    if (oneLine && !containsLineComment(tree, block.open.end, block.close.begin)) {
        slot.ownLine = false;
        slot.place = std::max(blanksBefore(bytes, block.close.begin), block.open.end);
        const bool blank = slot.place < block.close.begin;
        slot.before = " ";
        slot.behind = blank ? "" : " ";
        return slot;
    }
    const std::uint32_t last = block.items.empty() ? block.open.end : block.items.back().range.end;
    // Even if the first item follows `{` on its line, the indent is taken from an item that starts a line.
    slot.indent = outer + style.step;
    for (const Item& item : block.items) {
        const std::uint32_t start = lineStart(bytes, item.range.begin);
        if (blanksAfter(bytes, start) == item.range.begin)
            slot.indent = std::string(bytes.substr(start, item.range.begin - start));
    }
    // After all comments of the block, on the line above its `}`.
    const std::uint32_t closeLine = lineStart(bytes, block.close.begin);
    if (block.close.size() > 0 && closeLine >= last && closeLine > block.open.end &&
        blanksAfter(bytes, closeLine) == block.close.begin) {
        slot.place = closeLine;
        slot.behind = style.lineEnd;
        return slot;
    }
    slot.place = std::max(behindComments(tree, last), last);
    slot.before = style.lineEnd;
    // In `... } }` what follows on the line (at least the brace) needs a new line only after a line comment.
    const std::uint32_t rest = blanksAfter(bytes, slot.place);
    if (block.close.size() > 0 && rest == block.close.begin) {
        slot.behind = style.lineEnd + outer;
        slot.end = rest;
    }
    return slot;
}

Slot slotFor(const Tree& tree, const BlockItem* block, const EditStyle& style) {
    return block ? slotInBlock(tree, *block, block->type.range.begin, style) : slotInFile(tree, style);
}

/// The elements of a value's text: at commas outside of brackets and quotation marks.
std::vector<std::string_view> piecesOf(std::string_view text) {
    std::vector<std::string_view> pieces;
    std::size_t from = 0;
    int depth = 0;
    bool isQuoted = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') isQuoted = !isQuoted;
        if (isQuoted) continue;
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c != ',' || depth > 0) continue;
        pieces.push_back(text.substr(from, i - from));
        from = i + 1;
    }
    pieces.push_back(text.substr(from));
    return pieces;
}

/// With what stands between the old elements if that has comments and there are as many new ones.
std::string withComments(std::string_view bytes, const Value& value, std::string_view newText) {
    const std::vector<std::string_view> pieces = piecesOf(newText);
    if (pieces.size() != value.elements.size()) return std::string(newText);
    std::string text(pieces[0]);
    bool hasComment = false;
    for (std::size_t i = 1; i < pieces.size(); ++i) {
        const std::size_t from = value.elements[i - 1].range.end, to = value.elements[i].range.begin;
        const std::string_view between = bytes.substr(from, to - from);
        hasComment = hasComment || between.find("//") != std::string_view::npos || between.find("/*") != std::string_view::npos;
        text.append(between).append(pieces[i].substr(std::min(pieces[i].size(), pieces[i].find_first_not_of(' '))));
    }
    return hasComment ? text : std::string(newText);
}

} // namespace

TextEdit editSetValue(const Tree& tree, const Value& value, std::string_view newText) {
    // The value is missing: `Key =` is followed directly by other text.
    const auto bytes = tree.source().bytes();
    std::string text = withComments(bytes, value, newText);
    if (value.range.size() == 0) {
        const std::uint32_t place = value.range.begin;
        if (place > 0 && bytes[place - 1] == '=' && editStyle(tree).spacedEquals) text.insert(0, " ");
        if (!isLineEnd(bytes, place) && !isBlank(bytes[place])) text += ' ';
    }
    return {{tree.file(), value.range}, std::move(text)};
}

TextEdit editSetValue(const Tree& tree, TextRange value, std::string_view newText) {
    const std::vector<Item>* items = &tree.items();
    while (items) { // they are in the order of the text
        const auto behind = std::upper_bound(items->begin(), items->end(), value.begin,
                                             [](std::uint32_t at, const Item& item) { return at < item.range.begin; });
        if (behind == items->begin()) break;
        const Item& item = *std::prev(behind);
        const auto* assignment = item.as<AssignmentItem>();
        const auto* param = item.as<ParamItem>();
        const auto* block = item.as<BlockItem>();
        if (assignment && assignment->value.range == value) return editSetValue(tree, assignment->value, newText);
        if (param && param->value.range == value) return editSetValue(tree, param->value, newText);
        items = block ? &block->items : nullptr;
    }
    return editReplace(tree, value, newText);
}

TextEdit editReplace(const Tree& tree, TextRange range, std::string_view newText) {
    return {{tree.file(), range}, std::string(newText)};
}

namespace {

/// Whether two offsets are on one line.
bool isOneLine(std::string_view bytes, std::uint32_t from, std::uint32_t to) {
    return !hasLineEnd(bytes.substr(from, to - from));
}

/// Whether a block without a name could be the unit of a value before it: `5 C { }`.
bool isLikeUnit(const Item& item) {
    const auto* block = item.as<BlockItem>();
    return block && !block->name && findUnit(block->type.text);
}

/// After the last assignment, so that assignments stay together; nothing if it is the last item, or if there is no place after it.
std::optional<TextEdit> besideAssignments(const Tree& tree, const BlockItem* block, const Slot& slot, const EditStyle& style,
                                          const std::string& line) {
    const auto& items = block ? block->items : tree.items();
    if (items.empty()) return std::nullopt;
    const auto bytes = tree.source().bytes();
    const Item* beside = nullptr;
    for (const Item& item : items)
        if (item.as<AssignmentItem>()) beside = &item;
    if (beside == &items.back()) return std::nullopt;
    const Item& next = beside ? *std::next(beside) : items.front();
    if (!slot.ownLine && !isLikeUnit(next)) { // all of the block is on one line
        const std::uint32_t from = beside ? beside->range.end : block->open.end;
        return at(tree, from, from, " " + line + (beside || isBlank(bytes[from]) ? "" : " "));
    }
    if (!beside || !slot.ownLine) return std::nullopt;
    const std::uint32_t end = behindComments(tree, beside->range.end);
    const std::uint32_t start = lineStart(bytes, beside->range.begin);
    const bool beginsLine = blanksAfter(bytes, start) == beside->range.begin;
    const std::string indent = beginsLine ? std::string(bytes.substr(start, beside->range.begin - start)) : slot.indent;
    // Only if its line ends there, so that the rest of the line stays with it.
    if (isLineEnd(bytes, blanksAfter(bytes, end))) return at(tree, end, end, style.lineEnd + indent + line);
    if (block && !isLikeUnit(next) && isOneLine(bytes, block->open.end, next.range.begin)) // `Robot r { Config=A Controller c {`
        return at(tree, beside->range.end, beside->range.end, " " + line);
    return std::nullopt;
}

/// The start of the line of the first item, or of the comments directly above it.
std::uint32_t startWithComments(const Tree& tree, const Item& first) {
    const auto bytes = tree.source().bytes();
    const auto& tokens = tree.tokens();
    auto token = std::lower_bound(tokens.begin(), tokens.end(), first.range.begin,
                                  [](const Token& t, std::uint32_t offset) { return t.range.begin < offset; });
    std::uint32_t start = lineStart(bytes, first.range.begin);
    for (int lineEnds = 0; token != tokens.begin() && lineEnds < 2;) {
        --token;
        if (token->kind == TokenKind::LineEnd) ++lineEnds;
        if (token->kind != TokenKind::LineComment && token->kind != TokenKind::BlockComment) continue;
        lineEnds = 0;
        start = lineStart(bytes, token->range.begin);
    }
    return start == 0 && tokens.front().kind == TokenKind::Bom ? tokens.front().range.end : start;
}

/// The first setting of a file: behind the directives and Params at its top, or else in front of all items. Nothing if there are no
/// other items, or if their line does not end there.
std::optional<TextEdit> atTopOfFile(const Tree& tree, const EditStyle& style, const std::string& line) {
    const auto& items = tree.items();
    const auto other = std::find_if(items.begin(), items.end(), [](const Item& item) {
        return !item.as<ImportItem>() && !item.as<ModuleItem>() && !item.as<ParamItem>();
    });
    if (other == items.end()) return std::nullopt;
    if (other == items.begin()) {
        const std::uint32_t start = startWithComments(tree, *other);
        return at(tree, start, start, line + style.lineEnd + style.lineEnd);
    }
    const auto bytes = tree.source().bytes();
    const std::uint32_t end = behindComments(tree, std::prev(other)->range.end);
    if (!isLineEnd(bytes, blanksAfter(bytes, end))) return std::nullopt;
    return at(tree, end, end, style.lineEnd + line);
}

} // namespace

TextEdit editAddAssignment(const Tree& tree, const BlockItem* block, std::string_view key, std::string_view text) {
    const EditStyle style = editStyle(tree);
    const Slot slot = slotFor(tree, block, style);
    const std::string line = std::string(key) + (spacedEquals(tree, block, style) ? " = " : "=") + std::string(text);
    if (const auto beside = besideAssignments(tree, block, slot, style, line)) return *beside;
    const auto isSetting = [](const Item& item) { return item.as<AssignmentItem>() != nullptr; };
    if (!block && std::ranges::none_of(tree.items(), isSetting))
        if (const auto first = atTopOfFile(tree, style, line)) return *first;
    return at(tree, slot.place, std::max(slot.end, slot.place),
              slot.before + (slot.ownLine ? slot.indent : "") + line + slot.behind);
}

TextEdit editAddParam(const Tree& tree, const BlockItem& block, std::string_view name, std::string_view text) {
    const EditStyle style = editStyle(tree);
    const std::string line = "Param " + std::string(name) + " = " + std::string(text);
    const Item* last = nullptr;
    for (const Item& item : block.items)
        if (item.as<ParamItem>()) last = &item;
    if (block.items.empty() || last == &block.items.back()) return editAddItem(tree, &block, line);
    const auto bytes = tree.source().bytes();
    const std::uint32_t from = last ? last->range.end : block.open.end;
    const std::uint32_t end = std::max(behindComments(tree, from), from);
    const std::uint32_t start = last ? lineStart(bytes, last->range.begin) : 0;
    const bool beginsLine = last && blanksAfter(bytes, start) == last->range.begin;
    const std::string indent = beginsLine ? std::string(bytes.substr(start, last->range.begin - start))
                                          : slotInBlock(tree, block, block.type.range.begin, style).indent;
    if (isLineEnd(bytes, blanksAfter(bytes, end))) return at(tree, end, end, style.lineEnd + indent + line);
    const Item& next = last ? *std::next(last) : block.items.front();
    if (isLikeUnit(next)) return editAddItem(tree, &block, line);
    return at(tree, from, from, " " + line + (isBlank(bytes[from]) ? "" : " "));
}

TextEdit editAddItem(const Tree& tree, const BlockItem* block, std::string_view itemText) {
    const EditStyle style = editStyle(tree);
    Slot slot = slotFor(tree, block, style);
    while (!itemText.empty() &&
           (isLineEnd(itemText, static_cast<std::uint32_t>(itemText.size() - 1)) || isBlank(itemText.back())))
        itemText.remove_suffix(1);
    const bool needsLine = hasLineEnd(itemText) || itemText.starts_with('#') || itemText.find("//") != std::string_view::npos;
    if (!slot.ownLine && needsLine && block) {
        // A one-line block is expanded for a multi-line item.
        const auto bytes = tree.source().bytes();
        const std::string outer = indentOfLine(bytes, block->type.range.begin);
        slot.indent = outer + style.step;
        slot.before = style.lineEnd;
        slot.behind = style.lineEnd + outer;
        const std::uint32_t close = block->close.begin;
        return at(tree, slot.place, close,
                  slot.before + reindent(itemText, slot.indent, style.lineEnd) +
                      (block->close.size() ? slot.behind : style.lineEnd));
    }
    return at(tree, slot.place, std::max(slot.end, slot.place),
              slot.before + reindent(itemText, slot.ownLine ? slot.indent : "", style.lineEnd) + slot.behind);
}

TextEdit editRemoveItem(const Tree& tree, const Item& item) {
    const auto bytes = tree.source().bytes();
    const std::uint32_t start = lineStart(bytes, item.range.begin);
    const std::uint32_t before = blanksBefore(bytes, item.range.begin);
    const std::uint32_t after = blanksAfter(bytes, item.range.end);
    const bool first = before == start;
    if (first && isLineEnd(bytes, after)) {
        // If the item is alone on its lines, whole lines are removed. On the last line, if it has no final line end, the
        // preceding line end is removed too.
        if (after >= bytes.size() && start > 0) {
            std::uint32_t previousEnd = start - 1;
            if (previousEnd > 0 && bytes[previousEnd] == '\n' && bytes[previousEnd - 1] == '\r') --previousEnd;
            return at(tree, previousEnd, after, "");
        }
        return at(tree, start, afterLineEnd(bytes, after), "");
    }
    if (first) return at(tree, item.range.begin, after, ""); // the text after it moves to its position
    if (isLineEnd(bytes, after)) return at(tree, before, item.range.end, "");
    return at(tree, before, item.range.end, after > item.range.end ? "" : " ");
}

} // namespace trundle
