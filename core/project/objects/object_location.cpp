#include "project/objects/object_location.h"

#include "model/config_blocks.h"
#include "model/dotted_path.h"
#include "model/provenance.h"
#include "model/robot_path.h"

namespace trundle {

namespace {

bool isMember(const LoadedProject& loaded, std::string_view name) {
    const ExperimentSpec& e = *loaded.experiment;
    return std::ranges::find(e.robots, name, &RobotSpec::name) != e.robots.end() ||
           std::ranges::find(e.statics, name, &StaticSpec::name) != e.statics.end();
}

bool hasOwn(const Part& holder, const Part& block) {
    return !holder.parts.empty() && &holder.parts.front() <= &block && &block <= &holder.parts.back();
}

/// Descends by name; false if a name is not found.
bool descend(ObjectLocation& place, const Part& from, std::span<const std::string> words) {
    const Part* at = &from;
    const std::size_t membersBefore = place.members.size();
    std::vector<const Part*> above;
    for (const std::string& word : words) {
        const Part* next = at->find(word);
        if (!next) {
            place.members.resize(membersBefore);
            return false;
        }
        if (next->isRepeat() && next->name != word) place.members.emplace_back(next, memberName(word)->index);
        above.push_back(at);
        // through a Part into its config, and of a variant into what it is a variant of
        for (const Part* holder = at; holder->config && !hasOwn(*holder, *next); above.push_back(holder)) holder = holder->config;
        at = next;
    }
    place.part = at;
    place.above = std::move(above);
    return true;
}

/// The first Part on a path into a config is the instance that the rest is reached through; or a variant that has it from another
/// config.
void findPart(ObjectLocation& place, std::span<const std::string> words) {
    std::vector<const Part*> chain = place.above;
    chain.push_back(place.part);
    std::size_t used = 0;
    if (chain.size() > 1 && isVariant(*chain[0]) && chain[1] == chain[0]->config) place.instance = chain[0];
    for (const Part* part : chain) {
        if (place.instance || part->is(Role::Config)) continue;
        ++used;
        if (part->isPartUse()) place.instance = part;
    }
    for (; place.instance && used < words.size(); ++used) place.within = pathInside(place.within, words[used]);
}

/// Whether the experiment has what a path names: "row_1.swarm_3", or of all members of a Repeat "row.swarm_3".
bool isInExperiment(const LoadedProject& loaded, std::string_view path) {
    const ExperimentSpec& e = *loaded.experiment;
    const auto isMeant = [&](const auto& one) { return isNamedBy(one.name, path); };
    return std::ranges::any_of(e.robots, isMeant) || std::ranges::any_of(e.statics, isMeant);
}

/// From a Repeat at the top level to what is in it; returns the number of words that this takes. No part: it leads nowhere.
std::size_t enterRepeats(const LoadedProject& loaded, const std::vector<std::string>& words, ObjectLocation& place) {
    std::size_t used = 0;
    std::string path;
    while (place.part) {
        const Part& at = *place.part;
        path = pathInside(path, words[used]);
        if ((at.isRepeat() || place.member) && at.name != words[used])
            place.members.emplace_back(&at, memberName(words[used])->index);
        if (++used == words.size() || !at.isRepeat()) break;
        place.around.push_back(&at);
        place.part = inRepeat(at, words[used]);
        place.member = place.part && place.part != at.find(words[used]);
        if (place.member && !isInExperiment(loaded, pathInside(path, words[used]))) place.part = nullptr;
    }
    return used;
}

/// Finds the block of the world, or at the top level, that a path begins with; returns the number of words it takes.
std::size_t findTop(const LoadedProject& loaded, const std::vector<std::string>& words, ObjectLocation& place) {
    const Outline& outline = *loaded.outline;
    if ((place.part = outline.world.find(words[0]))) return enterRepeats(loaded, words, place);
    const Kind* kind = words.size() > 1 ? outline.registry().find(words[0]) : nullptr;
    const NameSpace* space = kind ? outline.spaceOf(*kind) : nullptr;
    const Part* part = space ? space->find(words[1]) : nullptr;
    if (part && part->kind == kind) {
        place.part = part;
        return 2;
    }
    place.part = layoutOfMember(outline, words[0]);
    place.member = place.part && isMember(loaded, words[0]);
    if (place.member) place.members.emplace_back(place.part, memberName(words[0])->index);
    if (!place.member) place.part = nullptr;
    return 1;
}

/// The innermost part below `part` that contains the offset, as a chain of parts that can be reached by name.
void deepest(const Part& part, FileId file, std::uint32_t offset, std::vector<const Part*>& chain,
             std::vector<const Part*>& best) {
    const bool here = part.range.file == file;
    if (here && !part.range.range.contains(offset)) return;
    chain.push_back(&part);
    if (here && chain.size() > best.size()) best = chain;
    for (const Part& inner : part.parts)
        if (!inner.name.empty() && part.find(inner.name) == &inner) deepest(inner, file, offset, chain, best);
    chain.pop_back();
}

} // namespace

std::optional<std::size_t> ObjectLocation::memberOf(const Part& repeat) const {
    const auto it = std::ranges::find(members, &repeat, &std::pair<const Part*, std::size_t>::first);
    return it == members.end() ? std::nullopt : std::optional(it->second);
}

const Part* configOf(const LoadedProject& loaded, const Part& instance) { return configOf(*loaded.outline, instance); }

std::optional<ObjectLocation> placeOf(const LoadedProject& loaded, std::string_view path) {
    ObjectLocation place;
    if (path.empty()) return place;
    const DottedPath dotted(path);
    if (!dotted.isComplete()) return std::nullopt;
    const std::vector<std::string>& words = dotted.words();
    const std::size_t used = findTop(loaded, words, place);
    if (!place.part) return std::nullopt;
    const std::span<const std::string> rest = std::span(words).subspan(used);
    const Part& top = *place.part;
    const auto withRepeats = [&] { place.above.insert(place.above.begin(), place.around.begin(), place.around.end()); };
    if (!isPlaced(top)) {
        if (!descend(place, top, rest)) return std::nullopt;
        if (place.around.empty()) findPart(place, rest);
        withRepeats();
        return place;
    }
    place.instance = &top;
    for (const std::string& word : rest) place.within = pathInside(place.within, word);
    if (descend(place, top, rest)) {
        withRepeats();
        return place;
    }
    const Part* config = configOf(loaded, top);
    if (!config || !descend(place, *config, rest)) return std::nullopt;
    return place;
}

std::string pathOf(const LoadedProject& loaded, const std::vector<const Part*>& chain) {
    if (chain.empty() || !chain[0]->kind) return {};
    const NameSpace* space = loaded.outline->spaceOf(*chain[0]->kind);
    if (!space || space->find(chain[0]->name) != chain[0]) return {};
    std::string path = space == &loaded.outline->world ? chain[0]->name : chain[0]->kind->name + "." + chain[0]->name;
    for (std::size_t i = 1; i < chain.size(); ++i) {
        if (chain[i]->name.empty() || chain[i - 1]->find(chain[i]->name) != chain[i]) return {};
        path += "." + chain[i]->name;
    }
    return path;
}

std::string objectAt(const LoadedProject& loaded, FileId file, std::uint32_t offset) {
    std::vector<const Part*> chain, best;
    for (const auto& part : loaded.outline->parts)
        if (!pathOf(loaded, {part.get()}).empty()) deepest(*part, file, offset, chain, best);
    return pathOf(loaded, best);
}

SourceRange blockOf(const LoadedProject& loaded, std::string_view path) {
    const std::optional<ObjectLocation> place = placeOf(loaded, path);
    if (!place) return {};
    if (place->part) return place->part->range;
    return {0, {0, static_cast<std::uint32_t>(loaded.trees[0]->source().bytes().size())}};
}

std::string pathOfConfig(const Part& config) { return config.kind->name + "." + config.name; }

std::vector<const Part*> controllersOf(const Part& instance) {
    std::vector<const Part*> controllers;
    for (const Part& part : instance.parts)
        if (part.is(Role::Controller)) controllers.push_back(&part);
    return controllers;
}

} // namespace trundle
