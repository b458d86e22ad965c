#pragma once
// Limits the console output of controllers. Counts ticks, not seconds, so that every run drops the same lines.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trundle {

class ConsoleLimit {
public:
    static constexpr std::uint64_t kLinesPerTick = 100; ///< of one robot with its controller and devices

    /// The beginning of `text`, in whole lines, that is still allowed in this tick; further lines are counted as dropped. `who`
    /// is "robot0" or "robot0/leftMotor".
    [[nodiscard]] std::string_view pass(std::string_view who, std::uint64_t tick, std::string_view text);
    /// Number of dropped lines since the last call, sorted by robot name.
    [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> takeDropped();

private:
    struct LineCounts {
        std::uint64_t tick = 0, lines = 0, dropped = 0;
    };
    std::map<std::string, LineCounts, std::less<>> m_robots;
    bool m_anyDropped = false;
};

} // namespace trundle
