#include "editor/text/symbols/text_navigation.h"

#include <algorithm>

#include "editor/text/symbols/text_location.h"
#include "project/objects/name_references.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// The target of a reference: a block or a Param.
struct Target {
    const BlockItem* block = nullptr;
    const ParamItem* param = nullptr;
    const Name* implied = nullptr; ///< a Param that no text declares: its first use
    bool operator==(const Target&) const = default;
    [[nodiscard]] bool known() const { return block || param || implied; }
};

bool holds(const std::vector<Item>& items, const Target& target) {
    return std::any_of(items.begin(), items.end(), [&](const Item& item) {
        const auto* block = item.as<BlockItem>();
        return (target.block && block == target.block) || (target.param && item.as<ParamItem>() == target.param) ||
               (block && holds(block->items, target));
    });
}

SourceRange nameOf(const LoadedProject& loaded, const Target& target) {
    for (const auto& part : loaded.outline->parts)
        for (const SourceParam& param : part->params)
            if (target.implied && param.name == target.implied) return param.nameRange();
    for (const auto& tree : loaded.trees) {
        if (!holds(tree->items(), target)) continue;
        if (target.param) return {tree->file(), target.param->name.range};
        return {tree->file(), target.block->name ? target.block->name->range : target.block->type.range};
    }
    return {};
}

/// The block or Param whose definition has its name there.
Target givenAt(const TextLocation& place) {
    if (!place.item) return {};
    if (const auto* param = place.item->as<ParamItem>(); param && touches(param->name.range, place.offset))
        return {nullptr, param, nullptr};
    const auto* block = place.item->as<BlockItem>();
    return block && block->name && touches(block->name->range, place.offset) ? Target{block, nullptr, nullptr} : Target{};
}

/// If two references meet at the offset, the one that begins there is returned.
const NameReference* referenceAt(const std::vector<NameReference>& references, FileId file, std::uint32_t offset) {
    const NameReference* found = nullptr;
    for (const NameReference& m : references) {
        if (m.name.file != file || !touches(m.name.range, offset)) continue;
        if (!found || m.name.range.contains(offset)) found = &m;
    }
    return found;
}

std::optional<Definition> fileAt(const LoadedProject& loaded, const TextLocation& place) {
    const auto* import = place.item ? place.item->as<ImportItem>() : nullptr;
    if (!import) return std::nullopt;
    const auto& imports = loaded.outline->texts().imports;
    const auto target = imports.find(import);
    if (target == imports.end()) return std::nullopt;
    return Definition{{target->second, {0, 0}}, {place.file, import->pathRange}, import->path};
}

/// The enclosing blocks down to the target or to the block of the Param; false if the outline does not contain it.
bool chainTo(const Target& target, const Part& from, std::vector<const Part*>& chain) {
    chain.push_back(&from);
    const auto declares = [&](const SourceParam& param) { return target.param && param.name == &target.param->name; };
    const auto implies = [&](const auto& param) { return &param->name == target.implied; };
    if (target.block ? from.block == target.block
                     : std::ranges::any_of(from.params, declares) || std::ranges::any_of(from.implied, implies))
        return true;
    for (const Part& inner : from.parts)
        if (chainTo(target, inner, chain)) return true;
    chain.pop_back();
    return false;
}

/// The target defined or referenced at an offset, and the range of the reference; an unknown range at the definition.
std::pair<Target, SourceRange> targetAt(const TextLocation& place, const std::vector<NameReference>& references) {
    if (const Target given = givenAt(place); given.known()) return {given, {}};
    const NameReference* reference = referenceAt(references, place.file, place.offset);
    return reference ? std::pair(Target{reference->target, reference->param, reference->implied}, reference->name)
                     : std::pair(Target{}, SourceRange{});
}

} // namespace

std::optional<Symbol> symbolAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    if (file >= loaded.trees.size()) return std::nullopt;
    const std::vector<NameReference> references = referencesIn(loaded);
    const auto [target, word] = targetAt(placeAt(loaded, file, offset), references);
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
    return Symbol{target.block ? path : path + "." + name, name, here};
}

std::optional<Definition> definitionAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    if (file >= loaded.trees.size()) return std::nullopt;
    const TextLocation place = placeAt(loaded, file, offset);
    if (auto imported = fileAt(loaded, place)) return imported;
    const std::vector<NameReference> references = referencesIn(loaded);
    const auto [target, word] = targetAt(place, references);
    if (!target.known()) return std::nullopt;
    const SourceRange given = nameOf(loaded, target);
    if (!given.known()) return std::nullopt;
    return Definition{given, word.known() ? word : given, std::string(loaded.sources.slice(given))};
}

std::vector<SourceRange> usesAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    std::vector<SourceRange> uses;
    if (file >= loaded.trees.size()) return uses;
    const std::vector<NameReference> references = referencesIn(loaded);
    const Target target = targetAt(placeAt(loaded, file, offset), references).first;
    if (!target.known()) return uses;
    for (const NameReference& m : references)
        if (m.name.known() && Target{m.target, m.param, m.implied} == target) uses.push_back(m.name);
    std::sort(uses.begin(), uses.end());
    uses.erase(std::unique(uses.begin(), uses.end()), uses.end());
    if (const SourceRange given = nameOf(loaded, target); given.known()) {
        std::erase(uses, given);
        uses.insert(uses.begin(), given);
    }
    return uses;
}

} // namespace trundle
