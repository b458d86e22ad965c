#include "editor/text/symbols/text_location.h"

#include <algorithm>
#include <set>

#include "project/objects/object_location.h"

namespace trundle {
namespace {

/// The parts from `from` down to the one of this block; empty if the outline does not contain it.
bool chainTo(const BlockItem* block, const Part& from, std::vector<const Part*>& chain) {
    chain.push_back(&from);
    if (from.block == block) return true;
    for (const Part& inner : from.parts)
        if (chainTo(block, inner, chain)) return true;
    chain.pop_back();
    return false;
}

/// Also if the text being typed after the value was parsed as part of it.
const Part* configUnder(const LoadedProject& loaded, const Part& instance) {
    if (const Part* config = configOf(loaded, instance)) return config;
    const SourceAssignment* a = instance.assignments.find("Config");
    return a && !a->value->elements.empty() ? loaded.outline->configs.find(a->value->elements[0].text) : nullptr;
}

/// Enters the block in `items` that contains the offset, if there is one.
const std::vector<Item>* inner(const std::vector<Item>& items, TextLocation& place) {
    for (auto item = items.rbegin(); item != items.rend(); ++item) {
        const auto* block = item->as<BlockItem>();
        if (!block || block->open.end > place.offset || block->open.size() == 0) continue;
        const bool closed = block->close.size() > 0;
        const bool last = item == items.rbegin(); // an unclosed block extends to the next item
        if (closed ? place.offset > block->close.begin : !last && std::prev(item)->range.begin <= place.offset) return nullptr;
        place.blocks.push_back(block);
        return &block->items;
    }
    return nullptr;
}

} // namespace

TextLocation placeAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    TextLocation place;
    place.file = file;
    place.offset = offset;
    const std::vector<Item>* items = &loaded.trees[file]->items();
    while (const std::vector<Item>* below = inner(*items, place)) items = below;
    for (const Item& item : *items)
        if (item.range.begin <= offset && offset <= item.range.end) place.item = &item;

    if (place.block()) {
        for (const auto& part : loaded.outline->parts)
            if (chainTo(place.block(), *part, place.parts)) break;
    }
    const Part* part = place.parts.empty() ? nullptr : place.parts.back();
    place.kind = part ? part->kind : loaded.registry->find(place.block() ? place.block()->type.text : "settings");
    for (const Part* outer : place.parts) {
        if (outer->is(Role::Config)) place.config = outer;
        else if (isPlaced(*outer)) place.config = configUnder(loaded, *outer);
    }
    if (part && isPlaced(*part)) place.instance = part;
    if (part && part->is(Role::Config) && part->assignments.find("Config")) { // a variant
        place.instance = part;
        place.config = configUnder(loaded, *part);
    }
    return place;
}

const ParamItem* TextLocation::described() const {
    const auto* param = item ? item->as<ParamItem>() : nullptr;
    const bool isInside = param && param->open.size() && param->open.end <= offset;
    return isInside && (param->close.size() == 0 || offset <= param->close.begin) ? param : nullptr;
}

const Property* propertyOf(const TextLocation& place, std::span<const std::string> path) {
    if (path.empty()) return nullptr;
    if (path.size() == 1) {
        if (const Property* own = place.kind ? place.kind->find(path[0]) : nullptr) return own;
        return place.instance && place.config && place.config->kind ? place.config->kind->find(path[0]) : nullptr;
    }
    const Part* at = place.instance ? place.config : nullptr;
    for (std::size_t i = 0; at && i + 1 < path.size(); ++i) at = at->find(path[i]);
    return at && at->kind ? at->kind->find(path.back()) : nullptr;
}

std::vector<std::string> keyOf(const AssignmentItem& assignment) {
    std::vector<std::string> words;
    for (const Name& name : assignment.path) words.push_back(name.text);
    return words;
}

std::vector<const SourceParam*> paramsAt(const LoadedProject& loaded, const TextLocation& place) {
    std::vector<const SourceParam*> params;
    std::set<std::string_view> seen;
    const auto add = [&](const std::vector<SourceParam>& more) {
        for (const SourceParam& p : more)
            if (seen.insert(p.name->text).second) params.push_back(&p);
    };
    for (auto part = place.parts.rbegin(); part != place.parts.rend(); ++part) add((*part)->params);
    add(loaded.outline->params);
    return params;
}

} // namespace trundle
