#include "model/robot_path.h"

namespace trundle {

/// The number of the last member of a Repeat, Grid or Scatter called `stem`; `before` is what its name has in front, "lane_0.".
static std::optional<std::size_t> lastMember(const std::vector<RobotSpec>& robots, const std::string& before,
                                             std::string_view stem) {
    std::optional<std::size_t> last;
    const RobotSpec* previous = nullptr;
    for (const RobotSpec& robot : robots) {
        if (!robot.name.starts_with(before)) continue;
        const std::string_view inside = std::string_view(robot.name).substr(before.size()), word = firstWord(inside);
        if (!isMemberOf(word, stem)) continue;
        const bool isOfRepeat = word != inside;
        const bool isOfLayout = previous && robot.range.known() && previous->range == robot.range; // a robot may be called cart_2
        if (isOfRepeat || isOfLayout) last = std::max(last.value_or(0), memberName(word)->index);
        previous = &robot;
    }
    return last;
}

std::optional<MissingMember> missingMember(const std::vector<RobotSpec>& robots, std::string_view path) {
    std::string before;
    for (std::string_view rest = path; !rest.empty(); rest = withoutFirstWord(rest)) {
        const std::string word(firstWord(rest)), start = before + word;
        const std::optional<MemberName> wanted = memberName(word);
        const auto isIn = [&](const RobotSpec& robot) { return startsWithPath(robot.name, start); };
        if (wanted && std::ranges::none_of(robots, isIn)) {
            const std::optional<std::size_t> last = lastMember(robots, before, wanted->stem);
            if (!last || *last > wanted->index) return std::nullopt;
            const std::string stem(wanted->stem), name = stem + "_" + std::to_string(*last);
            return MissingMember{before + stem, word, name, before + name + std::string(path.substr(start.size()))};
        }
        before = start + ".";
    }
    return std::nullopt;
}

} // namespace trundle
