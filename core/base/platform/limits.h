#pragma once
#include <cstdint>

namespace trundle {

/// Resource limits of a process; 0 leaves a limit unchanged.
struct ResourceLimits {
    std::uint64_t memoryBytes = 0; ///< address space; ignored in sanitizer builds, whose shadow memory needs terabytes
    std::uint64_t cpuSeconds = 0;  ///< beyond it SIGXCPU
    std::uint64_t fileBytes = 0;   ///< largest file it may write; beyond it SIGXFSZ
    std::uint64_t openFiles = 0;   ///< file descriptors
    bool coreDumps = true;
};

/// Applies the limits to the calling process. Safe between fork and exec. False if the system refuses one.
[[nodiscard]] bool applyLimits(const ResourceLimits& limits) noexcept;

/// True in a sanitizer build, where memory limits are impossible.
[[nodiscard]] bool memoryLimitsAreOff() noexcept;

} // namespace trundle
