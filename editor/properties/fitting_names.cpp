#include "editor/properties/fitting_names.h"

#include <algorithm>

#include "model/config_blocks.h"
#include "model/name_walk.h"
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

/// Parts may hold very many.
constexpr std::size_t kMostNames = 2000, kMostBlocks = 20'000;

void addInside(const Part& config, const std::string& before, const std::vector<std::string>& choices, bool geoms,
               std::vector<std::string>& names) {
    NameWalk(kMostBlocks).inside(config, before, [&](const Part& part, const std::string& prefix) {
        if (names.size() > kMostNames) return false;
        if (!part.isRepeat() && fits(part, choices)) names.push_back(prefix + part.name);
        return geoms || !part.is(Role::Body);
    });
}

/// A Part or a Repeat with bodies stands for all of them: "left" for "left.wheel", "mast" for "mast_0.pole".
void addGroups(const Part& config, std::vector<std::string>& names) {
    const std::vector<std::string> bodies = names;
    NameWalk(kMostBlocks).inside(config, {}, [&](const Part& part, const std::string& prefix) {
        if (names.size() > kMostNames) return false;
        const std::string name = prefix + part.name, inside = name + (part.isRepeat() ? "_0." : ".");
        const bool isGroup = part.isRepeat() || part.isPartUse();
        if (isGroup && std::ranges::any_of(bodies, [&](const std::string& body) { return body.starts_with(inside); }))
            names.push_back(name);
        return isGroup;
    });
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
    if (config && property.name == "NoContact") addGroups(*config, found);
    if (!config && names("Body")) // of a joint between robots
        for (const auto& [part, name] : firstMembers(outline))
            if (const Part* used = isPlaced(*part) ? configOf(loaded, *part) : nullptr)
                addInside(*used, name + ".", choices, false, found);
    const bool looks = names("Material") || names("Surface");
    if (looks && !std::count(found.begin(), found.end(), "default")) found.insert(found.begin(), "default");
    if (names("world")) found.emplace_back("world");
    return found;
}

std::vector<std::string> fittingNames(const LoadedProject& loaded, const Property& property, const ObjectValues& instance) {
    const Part& part = *instance.part();
    if (!part.isPartUse()) return fittingNames(loaded, property, instance.config());
    std::vector<std::string> names = fittingNames(loaded, property, instance.definedIn());
    std::erase_if(names, [&](const std::string& name) { return name.starts_with(part.name + "."); }); // what is in it
    return names;
}

bool isBodyToCountFrom(const Kind& kind, const Property& property) {
    const bool hasIn = kind.role == Role::Body || kind.role == Role::Repeat || kind.name == "Part";
    return hasIn && property.name == "In";
}

std::optional<std::vector<std::string>> bodiesForIn(const LoadedProject& loaded, const std::string& path) {
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place || !place->part) return std::nullopt;
    const std::vector<const Part*>& above = place->above;
    const auto is = [&](Role role) { return std::ranges::any_of(above, [&](const Part* p) { return p->is(role); }); };
    if (!is(Role::Config) || is(Role::Body)) return std::nullopt;
    const auto holds = [](const Part* p) { return p->is(Role::Config) || p->isRepeat(); };
    auto holder = std::find_if(above.rbegin(), above.rend(), holds);
    for (auto next = std::next(holder); next != above.rend() && isVariant(**next) && (*next)->config == *holder; ++next)
        holder = next; // a variant has what its base has, and more
    std::vector<std::string> names;
    addInside(**holder, {}, {"Body"}, false, names);
    const std::string own = place->part->name;
    std::erase_if(names, [&](const std::string& name) { // it cannot count from itself, nor from what is in it
        return name == own || name.starts_with(own + ".") || (place->part->isRepeat() && name.starts_with(own + "_0."));
    });
    return names;
}

std::vector<std::string> robotNames(const LoadedProject& loaded) {
    std::vector<std::string> names;
    eachInWorld(*loaded.outline, [&](const Part& part, const std::string& path) {
        if (part.is(Role::Layout) || part.kind->name == "Robot") names.push_back(path);
    });
    return names;
}

} // namespace trundle
