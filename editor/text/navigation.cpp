#include "editor/text/navigation.h"

#include <algorithm>

#include "editor/text/text_place.h"
#include "project/mentions.h"
#include "project/object_place.h"

namespace trundle {
namespace {

bool touches(TextRange range, std::uint32_t offset) { return range.begin <= offset && offset <= range.end; }

/// What a mention means: a block or a Param.
struct Target {
    const BlockItem* block = nullptr;
    const ParamItem* param = nullptr;
    bool operator==(const Target&) const = default;
    [[nodiscard]] bool known() const { return block || param; }
};

bool holds(const std::vector<Item>& items, const Target& target) {
    return std::any_of(items.begin(), items.end(), [&](const Item& item) {
        const auto* block = item.as<BlockItem>();
        return (target.block && block == target.block) || (target.param && item.as<ParamItem>() == target.param) ||
               (block && holds(block->items, target));
    });
}

SourceRange nameOf(const Loaded& loaded, const Target& target) {
    for (const auto& tree : loaded.trees) {
        if (!holds(tree->items(), target)) continue;
        if (target.param) return {tree->file(), target.param->name.range};
        return {tree->file(), target.block->name ? target.block->name->range : target.block->type.range};
    }
    return {};
}

/// The block or Param whose own name stands there.
Target givenAt(const TextPlace& place) {
    if (!place.item) return {};
    if (const auto* param = place.item->as<ParamItem>(); param && touches(param->name.range, place.offset))
        return {nullptr, param};
    const auto* block = place.item->as<BlockItem>();
    return block && block->name && touches(block->name->range, place.offset) ? Target{block, nullptr} : Target{};
}

/// A mention touched on its right edge gives way to one that begins there.
const Mention* mentionAt(const std::vector<Mention>& mentions, FileId file, std::uint32_t offset) {
    const Mention* found = nullptr;
    for (const Mention& m : mentions) {
        if (m.name.file != file || !touches(m.name.range, offset)) continue;
        if (!found || m.name.range.contains(offset)) found = &m;
    }
    return found;
}

std::optional<Definition> fileAt(const Loaded& loaded, const TextPlace& place) {
    const auto* import = place.item ? place.item->as<ImportItem>() : nullptr;
    if (!import) return std::nullopt;
    const auto& imports = loaded.outline->texts().imports;
    const auto target = imports.find(import);
    if (target == imports.end()) return std::nullopt;
    return Definition{{target->second, {0, 0}}, {place.file, import->pathRange}, import->path};
}

/// The blocks down to the one that is the target, or that holds the Param; false where the outline has none.
bool chainTo(const Target& target, const Part& from, std::vector<const Part*>& chain) {
    chain.push_back(&from);
    const auto holds = [&](const PlacedParam& param) { return param.name == &target.param->name; };
    if (target.block ? from.block == target.block : std::any_of(from.params.begin(), from.params.end(), holds)) return true;
    for (const Part& inner : from.parts)
        if (chainTo(target, inner, chain)) return true;
    chain.pop_back();
    return false;
}

/// What is given or named at an offset, and the characters that name it; unknown characters where it is given there.
std::pair<Target, SourceRange> targetAt(const TextPlace& place, const std::vector<Mention>& mentions) {
    if (const Target given = givenAt(place); given.known()) return {given, {}};
    const Mention* mention = mentionAt(mentions, place.file, place.offset);
    return mention ? std::pair(Target{mention->target, mention->param}, mention->name) : std::pair(Target{}, SourceRange{});
}

} // namespace

std::optional<Symbol> symbolAt(const Loaded& loaded, FileId file, std::uint32_t offset) {
    if (file >= loaded.trees.size()) return std::nullopt;
    const std::vector<Mention> mentions = mentionsIn(loaded);
    const auto [target, word] = targetAt(placeAt(loaded, file, offset), mentions);
    if (!target.known()) return std::nullopt;
    const SourceRange given = nameOf(loaded, target);
    if (!given.known() || (target.block && !target.block->name)) return std::nullopt;
    const std::string name(loaded.sources.slice(given));
    const SourceRange here = word.known() ? word : given;
    std::vector<const Part*> chain;
    for (const auto& part : loaded.outline->parts)
        if (chainTo(target, *part, chain)) break;
    const std::string path = pathOf(loaded, chain);
    if (target.param && chain.empty()) return Symbol{"Param." + name, name, here};
    if (path.empty()) return std::nullopt;
    return Symbol{target.param ? path + "." + name : path, name, here};
}

std::optional<Definition> definitionAt(const Loaded& loaded, FileId file, std::uint32_t offset) {
    if (file >= loaded.trees.size()) return std::nullopt;
    const TextPlace place = placeAt(loaded, file, offset);
    if (auto imported = fileAt(loaded, place)) return imported;
    const std::vector<Mention> mentions = mentionsIn(loaded);
    const auto [target, word] = targetAt(place, mentions);
    if (!target.known()) return std::nullopt;
    const SourceRange given = nameOf(loaded, target);
    if (!given.known()) return std::nullopt;
    return Definition{given, word.known() ? word : given, std::string(loaded.sources.slice(given))};
}

std::vector<SourceRange> usesAt(const Loaded& loaded, FileId file, std::uint32_t offset) {
    std::vector<SourceRange> uses;
    if (file >= loaded.trees.size()) return uses;
    const std::vector<Mention> mentions = mentionsIn(loaded);
    const Target target = targetAt(placeAt(loaded, file, offset), mentions).first;
    if (!target.known()) return uses;
    for (const Mention& m : mentions)
        if (m.name.known() && Target{m.target, m.param} == target) uses.push_back(m.name);
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    if (const SourceRange given = nameOf(loaded, target); given.known()) {
        std::erase(uses, given);
        uses.insert(uses.begin(), given);
    }
    return uses;
}

} // namespace trundle
