#include "project/edits/path_after_edit.h"

#include <algorithm>
#include <vector>

#include "model/dotted_path.h"
#include "project/objects/object_location.h"

namespace trundle {
namespace {

using Siblings = std::vector<const Part*>;

Siblings innerOf(const Part& part) {
    Siblings inner;
    for (const Part& each : part.parts) inner.push_back(&each);
    return inner;
}

/// The objects in the name space of a top-level part.
const Siblings& spaceOf(const Outline& outline, const Part& part) {
    const NameSpace* space = part.kind ? outline.spaceOf(*part.kind) : nullptr;
    return (space ? *space : outline.world).all();
}

const Part* named(const Siblings& siblings, const std::string& name) {
    const auto found = std::ranges::find(siblings, name, &Part::name);
    return found == siblings.end() ? nullptr : *found;
}

/// The part of `after` that `part` of `before` has become.
const Part* counterpart(const Siblings& before, const Siblings& after, const Part& part) {
    if (const Part* same = named(after, part.name)) return same;
    if (before.size() != after.size()) return nullptr;
    const Part* other = after[std::size_t(std::ranges::find(before, &part) - before.begin())];
    return other->block->type.text == part.block->type.text && !named(before, other->name) ? other : nullptr;
}

} // namespace

std::optional<std::string> pathAfterEdit(const LoadedProject& before, const LoadedProject& after, const std::string& path) {
    if (path.empty()) return path;
    const auto place = placeOf(before, path);
    if (!place || !place->part) return placeOf(after, path) ? std::optional(path) : std::nullopt;
    if (!place->around.empty()) return placeOf(after, path) ? std::optional(path) : std::nullopt;
    const Part* top = topOf(*place);
    const bool isReached = top == place->instance && !place->within.empty();
    if (place->member) return placeOf(after, path) ? std::optional(path) : std::nullopt; // its name comes from its Grid
    const Part* topNow = counterpart(spaceOf(*before.outline, *top), spaceOf(*after.outline, *top), *top);
    if (!topNow) return std::nullopt;
    // "robot0" or "RobotConfig.Rover", then the names of the inner blocks.
    const bool hasSpace = top != place->instance && firstWord(path) != top->name;
    std::string now = hasSpace ? pathInside(firstWord(path), topNow->name) : topNow->name;
    std::string_view rest = withoutFirstWord(hasSpace ? withoutFirstWord(path) : path);
    const Part* from = isReached ? configOf(before, *top) : top;
    const Part* to = isReached ? configOf(after, *topNow) : topNow;
    while (!rest.empty()) {
        const std::string name(firstWord(rest));
        const Siblings all = from ? innerOf(*from) : Siblings{};
        const Part* part = named(all, name);
        if (!part || !to) { // for example the controller, which is in the instance
            now = pathInside(now, rest);
            return placeOf(after, now) ? std::optional(now) : std::nullopt;
        }
        const Part* partNow = counterpart(all, innerOf(*to), *part);
        if (!partNow) return std::nullopt;
        now = pathInside(now, partNow->name);
        rest = withoutFirstWord(rest);
        from = part->config ? part->config : part;
        to = partNow->config ? partNow->config : partNow;
    }
    return now;
}

} // namespace trundle
