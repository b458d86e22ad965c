#include "run/logs/log_choice.h"

#include <algorithm>
#include <set>

#include "base/spelling.h"
#include "model/robot_path.h"

namespace trundle {
namespace {

constexpr std::size_t kMaxListed = 12;

/// For messages: "robot0, robot1 and 98 more".
std::string listed(const std::vector<std::string>& names) {
    if (names.empty()) return "there are none";
    std::string text = names.size() == 1 ? "there is " : "there are ";
    for (std::size_t i = 0; i < names.size() && i < kMaxListed; ++i) text += (i ? ", " : "") + names[i];
    if (names.size() > kMaxListed) text += " and " + std::to_string(names.size() - kMaxListed) + " more";
    return text;
}

/// What is said about an unknown name, and the names that it may mean.
struct Advice {
    std::string words;
    std::vector<std::string> suggestions;
};

Advice adviceFrom(const std::string& written, const std::vector<std::string>& names) {
    const auto isInside = [&](const std::string& name) { return name.ends_with("." + written); };
    if (const auto inside = std::ranges::find_if(names, isInside); inside != names.end()) return {listed(names), {*inside}};
    return {listed(names), nearestWords(written, names)};
}

void unknownName(const ComponentSpec& spec, const char* key, std::size_t k, const std::string& what, const Advice& advice,
                 Diagnostics& diagnostics) {
    const ResolvedValue* value = spec.find(key);
    Diagnostic& d = diagnostics.error(Code::UnknownReference, value && value->range.known() ? value->rangeOf(k) : spec.nameRange,
                                      "no " + what + " is called '" + spec.texts(key)[k] + "'; " + advice.words);
    d.suggestions = advice.suggestions;
}

/// A name of two words or that begins with a digit, which is reported where it is given.
bool hasBrokenName(const RobotSpec& robot) {
    return robot.name.find(' ') != std::string::npos || (robot.name[0] >= '0' && robot.name[0] <= '9');
}

Advice adviceForRobot(const std::string& written, const std::vector<RobotSpec>& robots) {
    if (const std::optional<MissingMember> missing = missingMember(robots, written))
        return {missing->all + " has no member " + missing->name + ", the last one is " + missing->last, {missing->inLast}};
    std::vector<std::string> names;
    std::set<std::string> known; // members of a Repeat have one name
    for (const RobotSpec& robot : robots)
        if (std::string all = nameOfAll(robot.name); known.insert(all).second) names.push_back(std::move(all));
    return adviceFrom(written, names);
}

/// The pattern "swarm_*/pose" for "swarm/pose", if swarm is a Grid or Scatter whose members have such a signal; else empty.
std::string patternForMembers(const std::string& written, const SignalLayout& layout) {
    const std::size_t slash = written.find('/');
    if (slash == std::string::npos || slash == 0) return {};
    const std::string grid = written.substr(0, slash), rest = written.substr(slash);
    for (const SignalEntry& entry : layout.entries()) {
        const std::size_t end = entry.path.find('/');
        if (end == std::string::npos || !isMemberOf(std::string_view(entry.path).substr(0, end), grid)) continue;
        if (matchesWildcard(rest, std::string_view(entry.path).substr(end))) return grid + "_*" + rest;
    }
    return {};
}

bool hasWildcard(std::string_view text) { return text.find_first_of("*?") != std::string_view::npos; }

/// The signals of the robot or static that `written` begins with, or all signals.
std::vector<std::string> signalNamesNear(const std::string& written, const SignalLayout& layout) {
    const std::string owner = written.substr(0, written.find('/') == std::string::npos ? 0 : written.find('/') + 1);
    std::vector<std::string> near, all;
    for (const SignalEntry& entry : layout.entries()) {
        all.push_back(entry.path);
        if (!owner.empty() && entry.path.starts_with(owner)) near.push_back(entry.path);
    }
    return near.empty() ? all : near;
}

Advice adviceForSignal(const std::string& written, const SignalLayout& layout) {
    const std::string pattern = patternForMembers(written, layout);
    if (!pattern.empty()) return {"its members are meant by '" + pattern + "'", {pattern}};
    return adviceFrom(written, signalNamesNear(written, layout));
}

} // namespace

bool matchesWildcard(std::string_view pattern, std::string_view text) {
    std::size_t p = 0, t = 0, star = std::string_view::npos, resume = 0;
    while (t < text.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = t;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == text[t])) {
            ++p;
            ++t;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            t = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::vector<std::size_t> chooseRobots(const ComponentSpec& spec, const std::vector<RobotSpec>& robots, Diagnostics& diagnostics) {
    std::vector<bool> chosen(robots.size(), false);
    const std::vector<std::string> written = spec.texts("Robot");
    const RobotNames isRobot(robots);
    for (std::size_t i = 0; written.empty() && i < robots.size(); ++i) chosen[i] = !robots[i].scenery;
    for (std::size_t k = 0; k < written.size(); ++k) {
        const std::string& name = written[k];
        const auto own = std::ranges::find(robots, name, &RobotSpec::name);
        bool found = own != robots.end();
        if (found) chosen[static_cast<std::size_t>(own - robots.begin())] = true;
        for (std::size_t i = 0; i < robots.size() && own == robots.end(); ++i)
            if (matchesWildcard(name, robots[i].name) || isNamedBy(robots[i].name, name, isRobot)) chosen[i] = found = true;
        if (!found && std::ranges::none_of(robots, hasBrokenName))
            unknownName(spec, "Robot", k, "robot", adviceForRobot(name, robots), diagnostics);
    }
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < robots.size(); ++i)
        if (chosen[i]) indices.push_back(i);
    return indices;
}

std::vector<SignalEntry> chooseSignals(const ComponentSpec& spec, const SignalLayout& layout, Diagnostics& diagnostics) {
    std::vector<SignalEntry> signals;
    std::set<std::uint32_t> taken;
    const auto take = [&](const SignalEntry& entry) {
        if (taken.insert(entry.offset).second) signals.push_back(entry);
    };
    const std::vector<std::string> written = spec.texts("Signals");
    for (std::size_t k = 0; k < written.size(); ++k) {
        const std::string& name = written[k];
        bool found = false;
        if (const auto entry = layout.find(name)) {
            take(*entry);
            found = true;
        } else if (hasWildcard(name)) {
            for (const SignalEntry& entry : layout.entries()) {
                if (!matchesWildcard(name, entry.path)) continue;
                take(entry);
                found = true;
            }
        }
        if (!found) unknownName(spec, "Signals", k, "signal", adviceForSignal(name, layout), diagnostics);
    }
    return signals;
}

} // namespace trundle
