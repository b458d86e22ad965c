#pragma once
#include <cstdint>
#include <string>

namespace trundle {

/// Identifies one process, also against a later one with the same process id.
struct ProcessIdentity {
    std::int64_t pid = 0;
    std::uint64_t start = 0; ///< start time in the kernel's clock ticks; 0 if unknown
    std::string host;

    bool operator==(const ProcessIdentity&) const = default;
};

[[nodiscard]] ProcessIdentity thisProcess();
/// True if the process is alive, or runs on another host where it cannot be checked.
[[nodiscard]] bool isPossiblyAlive(const ProcessIdentity& process);

} // namespace trundle
