#include "project/edits/wrapped_blocks.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "lang/characters.h"
#include "lang/edit_style.h"
#include "lang/tree_edit.h"
#include "model/dotted_path.h"
#include "schema/allowed_parents.h"

namespace trundle {

namespace {

/// Whether a reference is a word in the path of an override, "hull" in "chassis.hull.Mass".
bool isWordOfPath(const NameReference& reference, std::string_view word) {
    const std::string path = "." + reference.property, start = "." + std::string(word);
    return path.find(start + ".") != std::string::npos || path.find(start + "_") != std::string::npos;
}

} // namespace

Result<WrappedBlocks> WrappedBlocks::of(const LoadedProject& loaded, const std::vector<std::string>& paths,
                                        const std::string& wrapper) {
    WrappedBlocks blocks(loaded);
    if (Status status = blocks.take(paths, wrapper); !status.ok()) return status.error();
    return blocks;
}

Status WrappedBlocks::take(const std::vector<std::string>& paths, const std::string& wrapper) {
    const Result<std::vector<Chosen>> all = chosen(m_loaded, paths);
    if (!all.ok()) return all.error();
    for (const Chosen& c : all.value()) {
        const Part& part = *c.place.part;
        if (Status status = takeHolder(part, c.place.above.empty() ? nullptr : c.place.above.back(), wrapper); !status.ok())
            return status;
        if (!part.kind || !part.usable) return Error{Code::UnknownKind, part.title() + " has an error; fix it first"};
        if (!isAllowedInside(*part.kind, wrapper))
            return Error{Code::WrongPlace, allowedPlaces(*part.kind) + ", not in a " + wrapper};
        m_parentPath = withoutLastWord(c.path);
        m_blocks.push_back(&part);
        const std::uint32_t end = part.block->type.range.end;
        if (!part.block->name) change({{part.file, {end, end}}, " " + part.name}); // its default name may differ there
    }
    return {};
}

/// Fails if a block is not beside the first one.
Status WrappedBlocks::takeHolder(const Part& part, const Part* holder, const std::string& wrapper) {
    const bool isRepeat = wrapper == "Repeat", isOfBody = holder && holder->is(Role::Body);
    const bool fits = holder ? holder->is(Role::Config) || (isRepeat && isOfBody) : isRepeat;
    if (!fits)
        return Error{Code::WrongPlace, part.title() + " is not directly in a config; select bodies, joints and devices of one"};
    if (m_blocks.empty()) m_holder = holder;
    const auto placeName = [](const Part* at) { return at ? "is in " + at->title() : std::string("is at the top level"); };
    if (holder != m_holder)
        return Error{Code::WrongPlace, "select blocks of one config: " + part.title() + " " + placeName(holder) + ", " +
                                           m_blocks.front()->title() + " " + placeName(m_holder)};
    if (holder && part.file != holder->file)
        return Error{Code::WrongPlace, part.title() + " is in a file that " + holder->title() + " imports"};
    if (!m_blocks.empty() && part.file != file())
        return Error{Code::WrongPlace, part.title() + " and " + m_blocks.front()->title() + " are in different files"};
    return {};
}

std::vector<const Part*> WrappedBlocks::siblings() const {
    std::vector<const Part*> all;
    if (m_holder)
        for (const Part& part : m_holder->parts) all.push_back(&part);
    else
        for (const auto& part : m_loaded.outline->parts) all.push_back(part.get());
    return all;
}

std::string WrappedBlocks::commonName() const {
    std::string common = m_blocks.front()->name;
    for (const Part* block : m_blocks) {
        std::size_t same = 0;
        while (same < common.size() && same < block->name.size() && common[same] == block->name[same]) ++same;
        const auto isUpper = [](char c) { return std::isupper(static_cast<unsigned char>(c)) || c == '_'; };
        while (same > 0 && same < block->name.size() && !isUpper(block->name[same])) --same; // only whole words
        common.resize(same);
    }
    while (!common.empty() && common.back() == '_') common.pop_back();
    if (!common.empty()) return common;
    const auto body = std::ranges::find_if(m_blocks, [](const Part* block) { return block->is(Role::Body); });
    return (body == m_blocks.end() ? m_blocks.front() : *body)->name;
}

/// Empty if one would have no name, or that of another.
std::map<const Part*, std::string> WrappedBlocks::shorterNames() const {
    const std::string common = commonName();
    std::map<const Part*, std::string> names;
    std::set<std::string> taken;
    for (const Part* block : m_blocks) {
        if (!block->block->name || !block->name.starts_with(common)) return {};
        std::string rest = block->name.substr(common.size());
        if (rest.starts_with('_')) rest.erase(0, 1);
        if (rest.empty() || !std::isalpha(static_cast<unsigned char>(rest[0]))) return {};
        rest[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(rest[0])));
        if (!taken.insert(rest).second) return {};
        names.emplace(block, std::move(rest));
    }
    return names;
}

void WrappedBlocks::shortenNames(const std::vector<NameReference>& references) {
    const std::map<const Part*, std::string> names = shorterNames();
    const auto renamed = [&](const NameReference& m) {
        return std::ranges::find(names, m.target, [](const auto& pair) -> const BlockItem* { return pair.first->block; });
    };
    const TextSet& texts = m_loaded.outline->texts();
    for (const NameReference& m : references) // a pattern, or a default that is found by its name
        if (const auto it = renamed(m); it != names.end() && (!m.name.known() || texts.slice(m.name) != it->first->name)) return;
    for (const auto& [block, name] : names) change({{block->file, block->block->name->range}, name});
    for (const NameReference& m : references)
        if (const auto it = renamed(m); it != names.end() && contains(m.name) && !isRemoved(m.name)) change({m.name, it->second});
    m_newNames = names;
}

const std::string& WrappedBlocks::nameOf(const Part& block) const {
    const auto it = m_newNames.find(&block);
    return it == m_newNames.end() ? block.name : it->second;
}

bool WrappedBlocks::contains(const SourceRange& range) const {
    return range.known() && std::ranges::any_of(m_blocks, [&](const Part* block) { return isWithin(range, block->range); });
}

const Part* WrappedBlocks::find(const BlockItem* block) const {
    const auto look = [block](const auto& self, const Part& part) -> const Part* {
        if (part.block == block) return &part;
        for (const Part& inner : part.parts)
            if (const Part* found = self(self, inner)) return found;
        return nullptr;
    };
    for (const Part* part : m_blocks)
        if (const Part* found = block ? look(look, *part) : nullptr) return found;
    return nullptr;
}

void WrappedBlocks::change(TextEdit edit) {
    for (const Part* block : m_blocks) {
        if (!isWithin(edit.range, block->range)) continue;
        std::vector<TextEdit>& edits = m_changes[block];
        edit.range.range.begin -= block->range.range.begin;
        edit.range.range.end -= block->range.range.begin;
        const auto same = std::ranges::find(edits, edit.range, &TextEdit::range);
        if (same == edits.end()) edits.push_back(edit);
        else if (edit.range.range.size() == 0 && same->text != edit.text) same->text += edit.text; // two additions
        return;
    }
}

void WrappedBlocks::remove(const Part& block, std::string_view key) {
    const SourceAssignment* a = block.assignments.find(key);
    const auto item = std::ranges::find_if(block.block->items, [&](const Item& i) { return i.as<AssignmentItem>() == a->item; });
    if (item == block.block->items.end()) return; // in a file that the block imports
    TextEdit edit = editRemoveItem(*m_loaded.trees[a->file], *item);
    edit.range.file = a->file;
    change(std::move(edit));
    m_removed.push_back({a->file, item->range});
}

bool WrappedBlocks::isRemoved(const SourceRange& range) const {
    return std::ranges::any_of(m_removed, [&](const SourceRange& removed) { return isWithin(range, removed); });
}

void WrappedBlocks::add(const Part& block, std::string_view key, const std::string& value) {
    TextEdit edit = editAddAssignment(*m_loaded.trees[block.file], block.block, key, value);
    edit.range.file = block.file;
    change(std::move(edit));
}

std::string WrappedBlocks::text() const {
    std::string all;
    for (const Part* block : m_blocks) {
        const SourceRange whole = withComments(m_loaded, block->range);
        const TextSet& texts = m_loaded.outline->texts();
        const auto changes = m_changes.find(block);
        const Result<std::string> written =
            applyEdits(texts.slice(block->range), changes == m_changes.end() ? std::vector<TextEdit>() : changes->second);
        const std::string_view above = texts.slice({whole.file, {whole.range.begin, block->range.range.begin}});
        const std::string behind(texts.slice({whole.file, {block->range.range.end, whole.range.end}}));
        const std::string_view bytes = m_loaded.trees[block->file]->source().bytes();
        const std::size_t indent = indentOfLine(bytes, block->range.range.begin).size();
        const std::string given(written.ok() ? written.value() : std::string(texts.slice(block->range)));
        all += (all.empty() ? "" : "\n") + dedented(above, indent) + dedented(given + behind, indent);
    }
    return all;
}

const Part& WrappedBlocks::position() const {
    const std::vector<const Part*> all = siblings();
    std::map<const Part*, std::size_t> order;
    for (const Part* part : all) order.emplace(part, order.size());
    const auto isOurs = [this](const Part* part) { return std::ranges::find(m_blocks, part) != m_blocks.end(); };
    for (const Part* candidate : m_blocks) {
        const bool keepsOrder = std::ranges::all_of(all, [&](const Part* other) {
            if (isOurs(other) || !other->kind) return true;
            return std::ranges::all_of(m_blocks, [&](const Part* block) {
                return !block->is(other->kind->role) || (order[other] < order[block]) == (order[other] < order[candidate]);
            });
        });
        if (keepsOrder) return *candidate;
    }
    return *m_blocks.front();
}

void WrappedBlocks::replaceBy(const std::string& text, EditBuilder& sheet) const {
    const Part& here = position();
    const Tree& tree = *m_loaded.trees[here.file];
    const std::string lineEnd = editStyle(tree).lineEnd + indentOfLine(tree.source().bytes(), here.range.range.begin);
    std::string out;
    for (const char c : text) out += c == '\n' ? lineEnd : std::string(1, c);
    sheet.add({withComments(m_loaded, here.range), out});
    for (const Part* block : m_blocks)
        if (block != &here) sheet.removeItem(withComments(m_loaded, block->range));
}

Status WrappedBlocks::prefixNames(const std::vector<NameReference>& references, const std::string& prefix,
                                  const std::string& ofOverrides, EditBuilder& sheet) const {
    const TextSet& texts = m_loaded.outline->texts();
    for (const NameReference& m : references) {
        const auto ours = std::ranges::find(m_blocks, m.target, &Part::block);
        if (ours == m_blocks.end() || contains(m.name)) continue;
        if (!m.name.known()) { // a default
            if (m.user && !contains(m.user->range))
                sheet.addAssignment(m.user->file, m.user->block, m.property, prefix + (*ours)->name);
            continue;
        }
        const auto meansOther = [&](const NameReference& other) {
            return other.name == m.name && other.target && !find(other.target);
        };
        if (std::ranges::any_of(references, meansOther))
            return Error{Code::Conflict, usersText({&m}) + " names it together with others; name it by itself first"};
        const std::string_view word = texts.slice(m.name);
        const auto at = m.name.range.begin;
        const std::string before = isWordOfPath(m, word) ? ofOverrides : prefix;
        if (m_newNames.contains(*ours)) sheet.add({m.name, before + nameOf(**ours)});
        else sheet.add({{m.name.file, {at, at}}, before});
    }
    return {};
}

} // namespace trundle
