#include "project/edits/edit_builder.h"

#include <set>

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "project/edits/plan_check.h"

namespace trundle {

namespace {

bool onlyBlanks(std::string_view text) { return std::all_of(text.begin(), text.end(), isBlank); }

std::size_t errorsIn(const Tree& tree) {
    const auto& all = tree.diagnostics();
    return static_cast<std::size_t>(
        std::count_if(all.begin(), all.end(), [](const Diagnostic& d) { return d.severity == Severity::Error; }));
}

/// Removed lines, and a blank line beside them that separates nothing then: another one, a brace or the file's begin or end is on its other side.
TextRange withBlankLine(std::string_view bytes, TextRange lines) {
    const std::string_view above = bytes.substr(0, lines.begin), below = bytes.substr(lines.end);
    const bool begins = above.empty() || above == "\xEF\xBB\xBF";
    if ((!begins && !above.ends_with('\n')) || !bytes.substr(lines.begin, lines.size()).ends_with('\n')) return lines;
    const std::size_t before = above.size() < 2 ? std::string_view::npos : above.rfind('\n', above.size() - 2);
    const std::string_view last = before == std::string_view::npos ? above : above.substr(before + 1);
    const std::string_view next = below.substr(0, below.find('\n') + 1);
    const auto firstOf = [](std::string_view text) { return text.find_first_not_of(" \t\r\n"); };
    const bool isBlankBefore = !begins && firstOf(last) == std::string_view::npos;
    const bool isBlankBehind = !next.empty() && firstOf(next) == std::string_view::npos;
    const bool opens = begins || (!isBlankBefore && last[last.find_last_not_of(" \t\r\n")] == '{');
    const bool closes = !isBlankBehind && (below.empty() || below[firstOf(below)] == '}');
    if (isBlankBehind && (isBlankBefore || opens)) lines.end += static_cast<std::uint32_t>(next.size());
    else if (isBlankBefore && closes) lines.begin -= static_cast<std::uint32_t>(last.size());
    return lines;
}

bool hasLineEnd(std::string_view text) { return text.find_first_of("\r\n") != std::string_view::npos; }

} // namespace

void EditBuilder::add(TextEdit edit) {
    const SourceRange& r = edit.range;
    if (m_loaded.trees[r.file]->source().slice(r.range) == edit.text) return;
    std::vector<TextEdit>& edits = m_edits[r.file];
    for (TextEdit& other : edits) {
        if (other.range.range != r.range) continue;
        if (r.range.size() > 0 && other.text == edit.text) return;
        if (r.range.size() > 0) continue;
        other.text += edit.text;
        return;
    }
    edits.push_back(std::move(edit));
}

void EditBuilder::addFirst(TextEdit edit) { m_first[edit.range.file].push_back(std::move(edit)); }

void EditBuilder::removeItem(SourceRange item) {
    std::vector<TextRange>& items = m_removed[item.file];
    if (std::find(items.begin(), items.end(), item.range) == items.end()) items.push_back(item.range);
}

void EditBuilder::addItem(FileId file, const BlockItem* block, const std::string& text) {
    m_items.emplace_back(file, block, restepped(text, editStyle(*m_loaded.trees[file]).step));
}

void EditBuilder::addAssignment(FileId file, const BlockItem* block, const std::string& key, const std::string& value) {
    add(editAddAssignment(*m_loaded.trees[file], block, key, value));
}

void EditBuilder::name(const BlockItem& block, FileId file, const std::string& name) {
    if (block.name) add({{file, block.name->range}, name});
    else add({{file, {block.type.range.end, block.type.range.end}}, " " + name});
}

void EditBuilder::placeRemovals(FileId file, std::vector<TextRange> items) {
    const Tree& tree = *m_loaded.trees[file];
    std::sort(items.begin(), items.end());
    std::vector<TextRange> groups;
    for (const TextRange& item : items) {
        if (!groups.empty() && item.begin < groups.back().end) continue; // nested in the item before
        if (!groups.empty() && onlyBlanks(tree.source().slice({groups.back().end, item.begin}))) groups.back().end = item.end;
        else groups.push_back(item);
    }
    std::vector<TextEdit> removals;
    for (const TextRange& group : groups) {
        const std::uint32_t from = removals.empty() ? 0 : removals.back().range.range.end;
        removals.push_back(editRemoveItem(tree, Item{group, ImportItem{}}));
        TextRange& lines = removals.back().range.range;
        lines = withBlankLine(tree.source().bytes(), lines);
        lines.begin = std::max(lines.begin, from);
    }
    std::vector<TextEdit> kept;
    for (const TextEdit& edit : m_edits[file]) {
        const TextRange r = edit.range.range;
        const bool gone = std::any_of(groups.begin(), groups.end(), [&](const TextRange& g) {
            return r.size() > 0 ? g.begin <= r.begin && r.end <= g.end : g.begin < r.begin && r.begin < g.end;
        });
        if (gone) continue;
        const auto hit = std::find_if(removals.begin(), removals.end(), [&](const TextEdit& removal) {
            const TextRange w = removal.range.range;
            return r.begin < w.end && (r.begin > w.begin || r.end > w.begin);
        });
        if (hit == removals.end()) {
            kept.push_back(edit);
            continue;
        }
        // An addition inside the blanks that a removal takes away: one combined edit.
        TextRange& w = hit->range.range;
        w = {std::min(w.begin, r.begin), std::max(w.end, r.end)};
        hit->text += edit.text;
    }
    kept.insert(kept.end(), removals.begin(), removals.end());
    m_edits[file] = std::move(kept);
}

Status EditBuilder::check(FileId file, const std::vector<TextEdit>& edits) const {
    const Tree& tree = *m_loaded.trees[file];
    Result<std::shared_ptr<const Tree>> after = applyEdits(tree, edits);
    if (!after.ok()) return Error{Code::EditRefused, "this cannot be done in one step: " + after.error().message};
    if (errorsIn(*after.value()) > errorsIn(tree))
        return Error{Code::UnexpectedText, tree.source().path() + " has errors here; fix them first"};
    return {};
}

Result<EditPlan> EditBuilder::plan(std::vector<std::string> selects) {
    FileEdits others = std::exchange(m_edits, {});
    for (const auto& [file, edits] : m_first)
        for (const TextEdit& edit : edits) add(edit);
    for (const auto& [file, edits] : others)
        for (const TextEdit& edit : edits) add(edit);
    std::map<std::pair<FileId, const BlockItem*>, std::string> items;
    for (const auto& [file, block, text] : m_items) {
        const Tree& tree = *m_loaded.trees[file];
        std::string& all = items[{file, block}];
        const bool oneLine = block && !hasLineEnd(tree.source().slice({block->open.end, block->close.begin}));
        const bool simple = !hasLineEnd(all) && !hasLineEnd(text) && all.find("//") == std::string::npos;
        if (!all.empty()) all += oneLine && simple ? " " : "\n";
        all += text;
    }
    for (const auto& [place, text] : items) add(editAddItem(*m_loaded.trees[place.first], place.second, text));
    for (auto& [file, ranges] : m_removed) placeRemovals(file, ranges);
    std::erase_if(m_edits, [](const auto& entry) { return entry.second.empty(); });
    for (const auto& [file, edits] : m_edits) {
        if (m_loaded.outline->texts().commandLine(file)) return Error{Code::EditRefused, "a --set text cannot be changed"};
        if (Status status = check(file, edits); !status.ok()) return status.error();
    }
    if (Status status = checkNames(m_loaded, m_edits); !status.ok()) return status.error();
    return EditPlan{std::move(m_edits), std::move(selects)};
}

void addBefore(const LoadedProject& loaded, const Part* block, FileId file, const std::string& text, EditBuilder& sheet) {
    if (!block) return sheet.addItem(file, nullptr, text);
    const Tree& tree = *loaded.trees[file];
    const std::uint32_t at = commentAbove(tree, block->range.range.begin);
    const std::string lineEnd = editStyle(tree).lineEnd;
    const std::string_view bytes = tree.source().bytes();
    const bool first =
        at == 0 || bytes[at - 1] == '\n' || bytes[at - 1] == '\r' || (at == 3 && bytes.starts_with("\xEF\xBB\xBF"));
    std::string out = first ? "" : lineEnd;
    for (const char c : text) out += c == '\n' ? lineEnd : std::string(1, c);
    sheet.add({{file, {at, at}}, out + lineEnd + lineEnd});
}

TextEdit copyBehind(const Tree& tree, TextRange item, const std::string& text) {
    const std::string_view bytes = tree.source().bytes();
    const std::string indent = indentOfLine(bytes, item.begin);
    std::uint32_t start = item.begin;
    while (start > 0 && isBlank(bytes[start - 1])) --start;
    const bool first =
        start == 0 || bytes[start - 1] == '\n' || bytes[start - 1] == '\r' || (start == 3 && bytes.starts_with("\xEF\xBB\xBF"));
    std::uint32_t end = item.end;
    bool last = true;
    for (const Token& token : tree.tokens()) {
        if (token.range.begin < item.end || token.kind == TokenKind::Space) continue;
        if (token.kind == TokenKind::LineComment || token.kind == TokenKind::BlockComment) {
            end = token.range.end;
            continue;
        }
        last = token.kind == TokenKind::LineEnd || token.kind == TokenKind::End;
        break;
    }
    const bool lines = text.find('\n') != std::string::npos || text.find("//") != std::string::npos;
    if (!first && !lines) return {{tree.file(), {item.end, item.end}}, " " + text};
    const std::string lineEnd = editStyle(tree).lineEnd;
    std::string out = lineEnd + indent;
    for (const char c : text) out += c == '\n' ? lineEnd + indent : std::string(1, c);
    if (last) return {{tree.file(), {end, end}}, out};
    if (!lines) return {{tree.file(), {item.end, item.end}}, " " + text};
    return {{tree.file(), {item.end, item.end}}, out + lineEnd + indent};
}

std::string usersText(const std::vector<const NameReference*>& references) {
    constexpr std::size_t kMost = 3;
    std::vector<std::string> users;
    for (const NameReference* m : references) {
        std::string user = m->user ? m->user->title() + " (" + m->property + ")" : m->property;
        if (std::find(users.begin(), users.end(), user) == users.end()) users.push_back(std::move(user));
    }
    std::string text;
    for (std::size_t i = 0; i < users.size() && i < kMost; ++i) text += (i ? ", " : "") + users[i];
    if (users.size() > kMost)
        text += " and " + std::to_string(users.size() - kMost) + (users.size() == kMost + 1 ? " other" : " others");
    return text;
}

std::string blockText(const LoadedProject& loaded, const SourceRange& block) {
    const SourceText& source = loaded.trees[block.file]->source();
    return dedented(source.slice(block.range), indentOfLine(source.bytes(), block.range.begin).size());
}

std::string dedented(std::string_view text, std::size_t most) {
    std::size_t common = most;
    for (std::size_t at = text.find('\n'); at != std::string_view::npos; at = text.find('\n', at + 1)) {
        const std::size_t first = text.find_first_not_of(" \t", at + 1);
        if (first != std::string_view::npos && text[first] != '\n' && text[first] != '\r')
            common = std::min(common, first - at - 1);
    }
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n') continue;
        out += text[i];
        if (text[i] != '\n' || common == std::string_view::npos) continue;
        for (std::size_t k = 0; k < common && i + 1 < text.size() && isBlank(text[i + 1]); ++k) ++i;
    }
    return out;
}

std::string restepped(const std::string& text, const std::string& step) {
    std::string own;
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 1)) {
        const std::size_t first = text.find_first_not_of(" \t", at + 1);
        const std::size_t width = first == std::string::npos || text[first] == '\n' ? 0 : first - at - 1;
        if (width > 0 && (own.empty() || width < own.size())) own = text.substr(at + 1, width);
    }
    if (own.empty() || own == step) return text;
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        out += text[i];
        if (text[i] != '\n') continue;
        for (; text.compare(i + 1, own.size(), own) == 0; i += own.size()) out += step;
    }
    return out;
}

void keepNames(const std::vector<Part>& siblings, const std::string& type, const std::vector<NameReference>& references,
               const std::vector<const Part*>& except, EditBuilder& sheet) {
    std::set<const BlockItem*> referenced;
    for (const NameReference& m : references)
        if (m.target && m.name.known()) referenced.insert(m.target);
    for (const Part& part : siblings) {
        if (part.block->name || part.block->type.text != type || !referenced.count(part.block)) continue;
        if (std::find(except.begin(), except.end(), &part) == except.end()) sheet.name(*part.block, part.file, part.name);
    }
}

} // namespace trundle
