#pragma once
#include <cstdint>
#include <string>

namespace trundle {

/// Tells one process from every other, also from a later one that was given the same number.
struct ProcessIdentity {
    std::int64_t pid = 0;
    std::uint64_t start = 0; ///< when it began, in the system's own ticks; 0 where that cannot be known
    std::string host;

    bool operator==(const ProcessIdentity&) const = default;
};

[[nodiscard]] ProcessIdentity thisProcess();
/// Of another host nobody can say, so it counts as alive.
[[nodiscard]] bool mayBeAlive(const ProcessIdentity& process);

} // namespace trundle
