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

const Part* named(const Siblings& siblings, std::string_view name) {
    const auto found = std::ranges::find(siblings, name, &Part::name);
    return found == siblings.end() ? nullptr : *found;
}

/// What a word of a path means: a block, or a Repeat, Grid or Scatter by the name of a member.
const Part* meant(const Siblings& siblings, std::string_view word) {
    const std::optional<MemberName> member = memberName(word);
    const Part* part = named(siblings, word);
    if (part || !member) return part;
    part = named(siblings, member->stem);
    return part && (part->isRepeat() || part->is(Role::Layout)) ? part : nullptr;
}

/// The word with the new name: of "roller_3" that of its Repeat, with the number.
std::string renamed(std::string_view word, const Part& before, const Part& after) {
    return after.name + std::string(word.substr(std::min(word.size(), before.name.size())));
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
    const auto there = [&](std::string now) { return placeOf(after, now) ? std::optional(std::move(now)) : std::nullopt; };
    const auto place = placeOf(before, path);
    if (!place || !place->part) return there(path);
    const Part* from = place->around.empty() ? topOf(*place) : place->around.front();
    const Part* to = counterpart(spaceOf(*before.outline, *from), spaceOf(*after.outline, *from), *from);
    if (!to) return std::nullopt;
    // "robot0", "row_3" or "RobotConfig.Rover", then the names of the inner blocks.
    const bool hasSpace = before.outline->spaceOf(*from->kind) != &before.outline->world;
    std::string now = hasSpace ? pathInside(firstWord(path), to->name) : renamed(firstWord(path), *from, *to);
    std::string_view rest = withoutFirstWord(hasSpace ? withoutFirstWord(path) : path);
    while (!rest.empty()) {
        const bool isOwn = meant(innerOf(*from), firstWord(rest)); // a controller; what is in a Repeat
        if (isPlaced(*from) && !isOwn) from = configOf(before, *from), to = configOf(after, *to);
        const Siblings all = from ? innerOf(*from) : Siblings{};
        const Part* part = meant(all, firstWord(rest));
        if (!part || !to) return there(pathInside(now, rest));
        const Part* partNow = counterpart(all, innerOf(*to), *part);
        if (!partNow) return std::nullopt;
        now = pathInside(now, renamed(firstWord(rest), *part, *partNow));
        rest = withoutFirstWord(rest);
        from = part;
        to = partNow;
    }
    return there(now);
}

} // namespace trundle
