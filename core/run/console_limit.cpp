#include "run/console_limit.h"

#include <algorithm>

namespace trundle {

std::string_view ConsoleLimit::pass(std::string_view who, std::uint64_t tick, std::string_view text) {
    const std::string_view robot = who.substr(0, who.find('/'));
    auto found = m_robots.find(robot);
    if (found == m_robots.end()) found = m_robots.emplace(robot, LineCounts{}).first;
    LineCounts& counts = found->second;
    if (counts.tick != tick) counts.lines = 0;
    counts.tick = tick;

    std::size_t end = 0;
    while (end < text.size() && counts.lines < kLinesPerTick) {
        const std::size_t lineEnd = text.find('\n', end);
        end = lineEnd == std::string_view::npos ? text.size() : lineEnd + 1;
        ++counts.lines;
    }
    const std::string_view rest = text.substr(end);
    if (rest.empty()) return text;
    counts.dropped += static_cast<std::uint64_t>(std::count(rest.begin(), rest.end(), '\n')) + (rest.ends_with('\n') ? 0 : 1);
    m_anyDropped = true;
    return text.substr(0, end);
}

std::vector<std::pair<std::string, std::uint64_t>> ConsoleLimit::takeDropped() {
    std::vector<std::pair<std::string, std::uint64_t>> dropped;
    if (!m_anyDropped) return dropped;
    m_anyDropped = false;
    for (auto& [robot, counts] : m_robots) {
        if (counts.dropped > 0) dropped.emplace_back(robot, counts.dropped);
        counts.dropped = 0;
    }
    return dropped;
}

} // namespace trundle
