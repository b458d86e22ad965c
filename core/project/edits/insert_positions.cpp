#include "project/edits/insert_positions.h"

#include <algorithm>

#include "model/dotted_path.h"
#include "schema/value_words.h"

namespace trundle {

std::string placesOf(const Kind& kind) {
    std::vector<std::string> all = allowedParents(kind);
    std::erase_if(all, [](const std::string& place) { return place == "Repeat" || place == "Ring"; }); // in the same configs
    for (std::string& place : all) place = place.empty() ? "the top level" : withArticle(place);
    return listText(all);
}

std::string definedAt(const LoadedProject& loaded, const std::string& path) {
    std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place || !place->part) return path;
    std::vector<const Part*>& chain = place->above;
    chain.push_back(place->part);
    const auto config = std::find_if(chain.rbegin(), chain.rend(), [](const Part* part) { return part->is(Role::Config); });
    if (config != chain.rend()) chain.erase(chain.begin(), config.base() - 1); // of a Part, its PartConfig
    return pathOf(loaded, chain);
}

const Kind* kindAt(const LoadedProject& loaded, const std::string& path) {
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    return place && place->part ? place->part->kind : nullptr;
}

std::string parentOf(const LoadedProject& loaded, const std::string& path) {
    std::string above(withoutLastWord(path));
    const Kind* kind = loaded.registry->find(above); // "Material" in "Material.red" is not an object
    const bool space = kind && (kind->role == Role::Material || kind->role == Role::Surface || kind->role == Role::Pattern ||
                                kind->role == Role::Config);
    return space ? std::string() : above;
}

std::vector<std::string> placesAround(const LoadedProject& loaded, const std::string& selected) {
    std::vector<std::string> places;
    const std::optional<ObjectLocation> place = selected.empty() ? std::nullopt : placeOf(loaded, selected);
    if (place && place->part) {
        for (std::string path = definedAt(loaded, selected); !path.empty(); path = parentOf(loaded, path)) places.push_back(path);
        if (const Part* instance = place->instance; instance && !instance->isPartUse()) {
            if (std::find(places.begin(), places.end(), instance->name) == places.end()) places.push_back(instance->name);
            else if (const Part* config = configOf(loaded, *instance)) places.push_back(config->kind->name + "." + config->name);
        }
    }
    places.emplace_back();
    return places;
}

std::optional<std::string> placeFor(const LoadedProject& loaded, const std::string& selected,
                                    std::span<const Kind* const> kinds) {
    for (const std::string& path : placesAround(loaded, selected)) {
        const Kind* here = kindAt(loaded, path);
        const std::string_view parent = here ? std::string_view(here->name) : std::string_view();
        if (!here && !path.empty()) continue;
        if (std::all_of(kinds.begin(), kinds.end(), [&](const Kind* kind) { return isAllowedInside(*kind, parent); }))
            return path;
    }
    return std::nullopt;
}

} // namespace trundle
