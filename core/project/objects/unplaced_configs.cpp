#include "project/objects/unplaced_configs.h"

#include <algorithm>

#include "project/objects/object_location.h"

namespace trundle {

std::vector<const Part*> configsWithoutInstances(const LoadedProject& loaded) {
    std::vector<const Part*> described;
    const Outline& outline = *loaded.outline;
    bool isAnyPlaced = std::ranges::any_of(outline.parts, [](const auto& part) { return isPlaced(*part); });
    eachInWorld(outline, [&](const Part& part, const std::string&) { isAnyPlaced = isAnyPlaced || isPlaced(part); });
    if (isAnyPlaced) return described;
    for (const Part* config : outline.configs.all())
        if (config->file == 0 && config->kind->name != "PartConfig") described.push_back(config);
    return described;
}

} // namespace trundle
