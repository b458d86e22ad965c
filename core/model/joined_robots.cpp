#include "model/joined_robots.h"

#include <algorithm>
#include <numeric>
#include <type_traits>

namespace trundle {

JoinedRobots::JoinedRobots(const ExperimentSpec& experiment)
    : m_groups(experiment.robots.size()), m_holds(experiment.robots.size()) {
    std::iota(m_groups.begin(), m_groups.end(), std::size_t{0});
    for (const Link<JointSpec>& joint : experiment.joints) add(experiment, joint);
    for (const Link<SpringSpec>& spring : experiment.springs) add(experiment, spring);
}

/// Scenery holds like the world and joins no robots: it stays where it is. A spring to either gives way.
template <class Spec> void JoinedRobots::add(const ExperimentSpec& experiment, const Link<Spec>& link) {
    const auto isHolder = [&](int robot) {
        return robot == kWorldBody || experiment.robots[static_cast<std::size_t>(robot)].scenery;
    };
    const bool byParent = isHolder(link.parentRobot), byChild = isHolder(link.childRobot);
    if ((byParent && byChild) || (std::is_same_v<Spec, SpringSpec> && (byParent || byChild))) return;
    if (!byParent && !byChild) {
        const std::size_t a = m_groups[static_cast<std::size_t>(link.parentRobot)],
                          b = m_groups[static_cast<std::size_t>(link.childRobot)];
        std::ranges::replace(m_groups, std::max(a, b), std::min(a, b));
        if (m_holds[std::min(a, b)].empty()) m_holds[std::min(a, b)] = m_holds[std::max(a, b)];
        return;
    }
    const int holder = byParent ? link.parentRobot : link.childRobot;
    const auto held = static_cast<std::size_t>(byParent ? link.childRobot : link.parentRobot);
    std::string& hold = m_holds[m_groups[held]];
    if (!hold.empty()) return;
    const std::string to = holder == kWorldBody ? "the world" : experiment.robots[static_cast<std::size_t>(holder)].name;
    hold = link.spec.name + " holds " + experiment.robots[held].name + " to " + to;
}

std::vector<std::size_t> JoinedRobots::with(std::size_t robot) const {
    std::vector<std::size_t> joined;
    for (std::size_t i = 0; i < m_groups.size(); ++i)
        if (m_groups[i] == m_groups[robot]) joined.push_back(i);
    return joined;
}

} // namespace trundle
