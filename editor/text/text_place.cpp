#include "editor/text/text_place.h"

#include <algorithm>
#include <set>

#include "project/object_place.h"

namespace trundle {
namespace {

/// The parts down to the one whose block this is; empty where the outline has none.
bool chainTo(const BlockItem* block, const Part& from, std::vector<const Part*>& chain) {
    chain.push_back(&from);
    if (from.block == block) return true;
    for (const Part& inner : from.parts)
        if (chainTo(block, inner, chain)) return true;
    chain.pop_back();
    return false;
}

/// Also where what is being typed behind it has run into the value.
const Part* likelyConfig(const Loaded& loaded, const Part& instance) {
    if (const Part* config = configOf(loaded, instance)) return config;
    const PlacedAssignment* a = instance.assignments.find("Config");
    return a && !a->value->elements.empty() ? loaded.outline->configs.find(a->value->elements[0].text) : nullptr;
}

/// Goes into the block of `items` that holds the offset, where there is one.
const std::vector<Item>* inner(const std::vector<Item>& items, TextPlace& place) {
    for (auto item = items.rbegin(); item != items.rend(); ++item) {
        const auto* block = item->as<BlockItem>();
        if (!block || block->open.end > place.offset || block->open.size() == 0) continue;
        const bool closed = block->close.size() > 0;
        const bool last = item == items.rbegin(); // an unclosed block goes on to the next item
        if (closed ? place.offset > block->close.begin : !last && std::prev(item)->range.begin <= place.offset) return nullptr;
        place.blocks.push_back(block);
        return &block->items;
    }
    return nullptr;
}

} // namespace

TextPlace placeAt(const Loaded& loaded, FileId file, std::uint32_t offset) {
    TextPlace place;
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
        else if (isPlaced(*outer)) place.config = likelyConfig(loaded, *outer);
    }
    if (part && isPlaced(*part)) place.instance = part;
    return place;
}

const Property* propertyOf(const TextPlace& place, std::span<const std::string> path) {
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

std::vector<const PlacedParam*> paramsAt(const Loaded& loaded, const TextPlace& place) {
    std::vector<const PlacedParam*> params;
    std::set<std::string_view> seen;
    const auto add = [&](const std::vector<PlacedParam>& more) {
        for (const PlacedParam& p : more)
            if (seen.insert(p.name->text).second) params.push_back(&p);
    };
    for (auto part = place.parts.rbegin(); part != place.parts.rend(); ++part) add((*part)->params);
    add(loaded.outline->params);
    return params;
}

} // namespace trundle
