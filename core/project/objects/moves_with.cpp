#include "project/objects/moves_with.h"

#include <algorithm>

#include "model/dotted_path.h"
#include "model/robot_path.h"
#include "project/objects/object_location.h"
#include "project/objects/part_values.h"

namespace trundle {
namespace {

/// The config or instance that a path leads into: "rover", "RobotConfig.Kit".
std::string rootOf(const std::string& path, const ObjectLocation& place) {
    if (place.instance && !place.instance->isPartUse() && !place.within.empty())
        return path.substr(0, path.size() - place.within.size() - 1);
    const std::size_t kind = path.find('.');
    return path.substr(0, kind == std::string::npos ? kind : path.find('.', kind + 1));
}

bool movesWithin(const LoadedProject& loaded, const std::string& path, const std::vector<std::string>& others, int depth) {
    constexpr int kDeepest = 100;
    const auto isIn = [&](const std::string& other) { return path != other && startsWithPath(path, other); };
    if (std::ranges::any_of(others, isIn)) return true;
    const auto whole = placeOf(loaded, path);
    if (!whole || !whole->part || depth > kDeepest) return false;
    const std::string root = rootOf(path, *whole);
    for (std::string at = path; at.size() > root.size(); at = std::string(withoutLastWord(at))) {
        const auto place = placeOf(loaded, at);
        const auto in = place && place->part ? valueAt(loaded, *place, "In") : std::nullopt;
        if (!in || in->texts.empty()) continue;
        std::string body; // in a member of a Repeat, and by a Param, also of what is around it
        for (std::string around = std::string(withoutLastWord(at)); body.empty(); around = std::string(withoutLastWord(around))) {
            const auto found = placeOf(loaded, around + "." + in->texts[0]);
            if (found && found->part && found->part->is(Role::Body)) body = around + "." + in->texts[0];
            if (around.size() <= root.size()) break;
        }
        if (body.empty()) continue;
        if (std::ranges::find(others, body) != others.end() || movesWithin(loaded, body, others, depth + 1)) return true;
    }
    return false;
}

} // namespace

bool movesWith(const LoadedProject& loaded, const std::string& path, const std::vector<std::string>& others) {
    return movesWithin(loaded, path, others, 0);
}

} // namespace trundle
