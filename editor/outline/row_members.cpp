#include "editor/outline/row_members.h"

#include <algorithm>

namespace trundle {

const std::string& nameOfMember(const ExperimentSpec& e, std::size_t member) {
    return member < e.robots.size() ? e.robots[member].name : e.statics[member - e.robots.size()].name;
}

std::size_t numberOfMember(const ExperimentSpec& e, const std::string& name) {
    const auto indexIn = [&](const auto& all) {
        return std::size_t(std::ranges::find_if(all, [&](const auto& one) { return one.name == name; }) - all.begin());
    };
    const std::size_t robot = indexIn(e.robots); // scenery that moves is among the robots, too
    const bool isRobot = robot < e.robots.size() && !e.robots[robot].scenery;
    return isRobot ? robot : e.robots.size() + indexIn(e.statics);
}

/// The robots, or the scenery, of one Grid or Scatter are contiguous in the experiment.
RowMembers membersOf(const LoadedProject& loaded) {
    RowMembers members;
    std::unordered_map<std::uint64_t, const Part*> layouts; // by file and start of their block
    const auto placeOf = [](const SourceRange& r) { return (std::uint64_t(r.file) << 32) | r.range.begin; };
    for (const auto& part : loaded.outline->parts)
        if (part->is(Role::Layout) && part->usable) layouts.emplace(placeOf(part->range), part.get());
    if (layouts.empty()) return members;
    const ExperimentSpec& e = *loaded.experiment;
    const auto add = [&](std::size_t i, const SourceRange& block) {
        const auto layout = layouts.find(placeOf(block));
        if (layout == layouts.end()) return;
        const auto [range, isNew] = members.try_emplace(layout->second, i, i);
        range->second.second = i + 1;
    };
    for (std::size_t i = 0; i < e.robots.size(); ++i)
        if (!e.robots[i].scenery) add(i, e.robots[i].range);
    for (std::size_t i = 0; i < e.statics.size(); ++i) add(e.robots.size() + i, e.statics[i].range);
    return members;
}

} // namespace trundle
