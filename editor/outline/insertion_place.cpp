#include "editor/outline/insertion_place.h"

#include <algorithm>
#include <cctype>

#include "model/config_blocks.h"
#include "model/name_walk.h"
#include "project/edits/insert_positions.h"

namespace trundle {
namespace {

constexpr std::size_t kMostSearched = 20'000; ///< blocks in Parts

/// The config that has, or is, the block at a path.
const Part* configAround(const LoadedProject& loaded, const std::string& path) {
    const auto place = placeOf(loaded, path);
    if (!place || !place->part) return nullptr;
    if (place->part->is(Role::Config)) return place->part;
    const auto above =
        std::find_if(place->above.rbegin(), place->above.rend(), [](const Part* p) { return p->is(Role::Config); });
    return above == place->above.rend() ? nullptr : *above;
}

std::string firstBodyIn(const Part& config) {
    std::string body;
    NameWalk(kMostSearched).inside(config, {}, [&](const Part& part, const std::string& prefix) {
        if (body.empty() && part.is(Role::Body) && part.usable) body = prefix + part.name;
        return body.empty();
    });
    return body;
}

/// Whether a Part of `config` would hold `other` in the end.
bool holds(const Part& config, const Part& other) {
    bool found = &config == &other;
    NameWalk(kMostSearched).inside(config, {}, [&](const Part& part, const std::string&) {
        found = found || part.config == &other;
        return !found;
    });
    return found;
}

/// The nearest block around a path that is no Repeat; nullptr at the top level.
const Part* holderOf(const LoadedProject& loaded, std::string path) {
    for (; !path.empty(); path = parentOf(loaded, path)) {
        const Kind* kind = kindAt(loaded, path);
        const auto place = placeOf(loaded, path);
        if (kind && kind->role != Role::Repeat) return place ? place->part : nullptr;
    }
    return nullptr;
}

/// A Repeat holds what its holder holds, of scenery only what stands still; geoms beside bodies are for scenery only.
bool mayHold(const Part* holder, const Kind* here, const Kind& kind) {
    const std::string_view name = holder ? std::string_view(holder->kind->name) : std::string_view();
    const bool isForRobots = name == "PartConfig" && !firstBodyIn(*holder).empty();
    const bool isRepeatOfScenery = name == "StaticConfig" && here && here->role == Role::Repeat;
    const bool standsStill = kind.role == Role::Geom || kind.role == Role::Repeat || kind.name == "Part";
    return isAllowedInside(kind, name) && !(isForRobots && kind.role == Role::Geom) && !(isRepeatOfScenery && !standsStill);
}

} // namespace

std::optional<std::string> insertionPlaceFor(const LoadedProject& loaded, const std::string& selected, const Kind& kind) {
    for (const std::string& path : placesAround(loaded, selected)) {
        const Kind* here = kindAt(loaded, path);
        if (!here && !path.empty()) continue;
        if (isAllowedInside(kind, here ? std::string_view(here->name) : std::string_view()) &&
            mayHold(holderOf(loaded, path), here, kind))
            return path;
    }
    return std::nullopt;
}

std::string partTextFor(const LoadedProject& loaded, const std::string& place, const Part& partConfig) {
    const Part* config = configAround(loaded, place);
    if (!config || !partConfig.usable || !partConfig.kind || partConfig.kind->name != "PartConfig") return {};
    const std::string body = firstBodyIn(*config);
    const bool isScenery = config->kind->name == "StaticConfig" || body.empty();
    if (holds(partConfig, *config) || (!isScenery && firstBodyIn(partConfig).empty())) return {};
    std::string name = partConfig.name;
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    std::string text = "Part " + name + " { Config=" + partConfig.name;
    for (const SourceParam& param : partConfig.params) {
        if (!param.required) continue;
        const std::string outside = config->kind->name == "StaticConfig" ? "world" : "$" + param.name->text;
        text += " " + param.name->text + "=" + (body.empty() ? outside : body);
    }
    return text + " }";
}

} // namespace trundle
