#include "editor/properties/fitting_names.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

bool fits(const Part& part, const std::vector<std::string>& choices) {
    if (!part.kind || part.name.empty()) return false;
    return choices.empty() || std::any_of(choices.begin(), choices.end(), [&](const std::string& c) {
               return c == part.kind->name || c == roleName(part.kind->role);
           });
}

bool wantsGeom(const Registry& registry, const std::vector<std::string>& choices) {
    return std::any_of(choices.begin(), choices.end(), [&](const std::string& c) {
        const Kind* kind = registry.find(c);
        return c == "Geom" || (kind && kind->role == Role::Geom);
    });
}

constexpr std::size_t kMostNames = 2000; // Parts may hold very many

void addInside(const Part& config, const std::string& before, const std::vector<std::string>& choices, bool geoms,
               std::vector<std::string>& names) {
    if (isVariant(config)) addInside(*config.config, before, choices, geoms, names);
    for (const Part& part : config.parts) {
        if (names.size() > kMostNames) return;
        if (part.isRepeat()) {
            addInside(part, before + part.name + "_0.", choices, geoms, names);
            continue;
        }
        if (fits(part, choices)) names.push_back(before + part.name);
        if (part.config) addInside(*part.config, before + part.name + ".", choices, geoms, names);
        if (!geoms || !part.is(Role::Body)) continue;
        for (const Part& geom : part.parts)
            if (fits(geom, choices)) names.push_back(before + part.name + "." + geom.name);
    }
}

} // namespace

std::vector<std::string> fittingNames(const LoadedProject& loaded, const Property& property, const Part* config) {
    const std::vector<std::string>& choices = property.choices;
    const auto names = [&](const char* word) { return std::count(choices.begin(), choices.end(), word) > 0; };
    const Outline& outline = *loaded.outline;
    std::vector<std::string> found;
    if (!choices.empty())
        for (const NameSpace* space :
             {&outline.materials, &outline.surfaces, &outline.patterns, &outline.configs, &outline.world})
            for (const Part* part : space->all())
                if (fits(*part, choices)) found.push_back(part->name);
    if (config) addInside(*config, {}, choices, wantsGeom(*loaded.registry, choices), found);
    if (!config && names("Body")) // of a joint between robots
        for (const auto& [part, name] : firstMembers(outline))
            if (const Part* used = isPlaced(*part) ? configOf(loaded, *part) : nullptr)
                addInside(*used, name + ".", choices, false, found);
    const bool looks = names("Material") || names("Surface");
    if (looks && !std::count(found.begin(), found.end(), "default")) found.insert(found.begin(), "default");
    if (names("world")) found.emplace_back("world");
    return found;
}

std::vector<std::string> robotNames(const LoadedProject& loaded) {
    std::vector<std::string> names;
    eachInWorld(*loaded.outline, [&](const Part& part, const std::string& path) {
        if (part.is(Role::Layout) || part.kind->name == "Robot") names.push_back(path);
    });
    return names;
}

} // namespace trundle
