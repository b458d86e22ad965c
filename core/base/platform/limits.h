#pragma once
#include <cstdint>

namespace trundle {

/// What a process may use at most; 0 leaves a limit as it is.
struct ResourceLimits {
    std::uint64_t memoryBytes = 0; ///< address space. Not set in builds with a sanitizer, whose shadow needs terabytes
    std::uint64_t cpuSeconds = 0;  ///< then SIGXCPU
    std::uint64_t fileBytes = 0;   ///< largest file it may write, then SIGXFSZ
    bool coreDumps = true;
};

/// Applies them to the calling process. Safe between fork and exec. False where the system refuses one.
[[nodiscard]] bool applyLimits(const ResourceLimits& limits) noexcept;

/// True in a build whose sanitizer makes memory limits impossible.
[[nodiscard]] bool memoryLimitsAreOff() noexcept;

} // namespace trundle
