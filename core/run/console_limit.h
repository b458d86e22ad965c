#pragma once
// Keeps a talkative controller from burying the console. Counts ticks, not seconds: the same run drops the same lines.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace trundle {

class ConsoleLimit {
public:
    static constexpr std::uint64_t kLinesPerTick = 100; ///< of one robot, its controller and its devices together

    /// The beginning of `text` that may still go out in this tick, whole lines; the others are counted. `who` is "robot0" or
    /// "robot0/leftMotor".
    [[nodiscard]] std::string_view pass(std::string_view who, std::uint64_t tick, std::string_view text);
    /// Lines dropped since the last call, by robot in the order of names.
    [[nodiscard]] std::vector<std::pair<std::string, std::uint64_t>> takeDropped();

private:
    struct Talk {
        std::uint64_t tick = 0, lines = 0, dropped = 0;
    };
    std::map<std::string, Talk, std::less<>> m_robots;
    bool m_anyDropped = false;
};

} // namespace trundle
