#pragma once
// Robots in paths: the name of a member of a Repeat in the world has several words, "row_3.cart".

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_set>
#include <vector>

#include "model/dotted_path.h"
#include "model/experiment_spec.h"
#include "model/outline.h"

namespace trundle {

/// The shortest start of a path, in whole words, for which `is(start)` holds; else empty.
template <class Is> std::string_view shortestStart(std::string_view path, const Is& is) {
    for (std::size_t end = firstWord(path).size(); end > 0 && end <= path.size();
         end = std::min(path.find('.', end + 1), path.size())) {
        if (is(path.substr(0, end))) return path.substr(0, end);
        if (end == path.size()) break;
    }
    return {};
}

/// The name of the robot that a path is of, "row_3.cart" of "row_3.cart.leftMotor"; its first word if it is of none.
inline std::string robotNameIn(const ExperimentSpec& experiment, std::string_view path) {
    const auto isRobot = [&](std::string_view name) { return std::ranges::find(experiment.robots, name, &RobotSpec::name) != experiment.robots.end(); };
    const std::string_view robot = shortestStart(path, isRobot);
    return std::string(robot.empty() ? firstWord(path) : robot);
}

/// The name of all the members that a robot in Repeats is one of: "row.cart" of "row_3.cart"; the name itself for any other robot.
inline std::string nameOfAll(std::string_view robot) {
    std::string all;
    for (std::string_view rest = robot; !rest.empty(); rest = withoutFirstWord(rest)) {
        const std::string_view word = firstWord(rest);
        const auto member = word == rest ? std::nullopt : memberName(word);
        all = pathInside(all, member ? member->stem : word);
    }
    return all;
}

/// The Grid or Scatter of which a path begins with a member, "swarm_12.chassis", in a Repeat "row_3.swarm_12.chassis".
struct LayoutMember {
    const Part* layout = nullptr; ///< nullptr: the path begins with something else
    std::string_view name;        ///< "row_3.swarm_12"
    [[nodiscard]] std::string_view all() const { return memberName(name)->stem; } ///< "row_3.swarm"
};
inline LayoutMember layoutMemberIn(const Outline& outline, std::string_view path) {
    LayoutMember member;
    member.name = shortestStart(path, [&](std::string_view name) {
        return !outline.world.find(name) && (member.layout = layoutOfMember(outline, name));
    });
    return member;
}

/// What is in a Repeat, a Grid or Scatter also by the name of a member; nullptr if there is nothing.
inline const Part* inRepeat(const Part& repeat, std::string_view word) {
    const std::optional<MemberName> member = memberName(word);
    if (const Part* part = repeat.find(word); part || !member) return part;
    const Part* layout = repeat.find(member->stem);
    return layout && layout->is(Role::Layout) ? layout : nullptr;
}

/// restBehind() beside what else there is: `cart_2` is no member of a `cart` of which `isOwn` says that it is there itself, and not
/// as its members.
template <class IsOwn>
std::optional<std::string_view> restBehind(std::string_view path, std::string_view name, const IsOwn& isOwn) {
    const std::optional<std::string_view> rest = restBehind(path, name);
    for (std::size_t begin = 0; rest && begin < name.size(); path = withoutFirstWord(path)) {
        const std::string_view word = firstWord(name.substr(begin));
        if (word != firstWord(path) && isOwn(std::string(name.substr(0, begin)).append(firstWord(path)))) return std::nullopt;
        begin += word.size() + 1;
    }
    return rest;
}

/// Whether a robot has this name, or is one of the members that it names: "row_3.cart" of "row.cart", "swarm_3" of "swarm".
inline bool isNamedBy(std::string_view robot, std::string_view name) {
    const auto rest = restBehind(name, robot);
    return rest && rest->empty();
}
/// The same beside what else there is.
template <class IsOwn> bool isNamedBy(std::string_view robot, std::string_view name, const IsOwn& isOwn) {
    const auto rest = restBehind(name, robot, isOwn);
    return rest && rest->empty();
}

/// Whether a name of the world is that of a block itself, and not of a Repeat, Grid or Scatter, which are there as their members.
struct IsOwnName {
    const Outline& outline;
    bool operator()(std::string_view name) const {
        const Part* part = outline.world.find(name);
        return part && !part->isRepeat() && !part->is(Role::Layout);
    }
};

/// A member that a Repeat, Grid or Scatter does not have, as a path names it.
struct MissingMember {
    std::string all;        ///< "row"; in another Repeat "lane_0.row"
    std::string name, last; ///< "row_9", and the last one that there is, "row_1"
    std::string inLast;     ///< the path with that one: "row_1.cart" for "row_9.cart"
};
/// Nothing if a path leads to no such member, or if no robot shows that there are others.
[[nodiscard]] std::optional<MissingMember> missingMember(const std::vector<RobotSpec>& robots, std::string_view path);

/// Whether a robot has a name.
class RobotNames {
public:
    explicit RobotNames(const std::vector<RobotSpec>& robots) {
        for (const RobotSpec& robot : robots) m_names.insert(robot.name);
    }
    bool operator()(std::string_view name) const { return m_names.contains(name); }

private:
    std::unordered_set<std::string_view> m_names;
};

} // namespace trundle
