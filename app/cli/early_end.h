#pragma once
// Messages and exit codes of a program that ends in the middle of a run. Everything here is async-signal-safe.

#include <atomic>
#include <cstdint>

#include "crash/crash_text.h"
#include "crash/kept_text.h"

namespace trundle {

enum class EarlyEndKind {
    Crash,         ///< a signal such as SIGSEGV
    Exit,          ///< module code called exit(), quick_exit() or _exit()
    NotResponding, ///< end requested, but a call or a solver step did not return
    Interrupted,   ///< end requested twice
};

struct EarlyEnd {
    EarlyEndKind kind = EarlyEndKind::Crash;
    CrashCause cause;          ///< of a crash or exit
    std::uint32_t waitedS = 0; ///< NotResponding
};

/// Poses of the robots, updated regularly during the run.
struct EarlyPoses {
    KeptText members; ///< members of "robots", without braces
    double timeS = 0; ///< simulated time
};

/// The data for a report, prepared before anything fails. Only `calls` refers to the heap.
struct EarlyEndFacts : CrashedRun {
    double startS = 0;             ///< on the monotonic clock
    bool terminal = false;         ///< standard error is a terminal: its last line may contain a progress bar
    std::atomic<bool> json{false}; ///< --json is set, and its object has not been printed
    /// Entries of "diagnostics" so far, without brackets.
    std::atomic<const KeptText*> diagnostics{nullptr};
    /// At most about a second old; nullptr: none yet.
    std::atomic<const EarlyPoses*> poses{nullptr};
    /// Set after the last tick: the complete results, printed instead of the few available in the middle of a run.
    std::atomic<const KeptText*> results{nullptr};
    bool hasModules = false; ///< their code is part of this process
    bool reported = false;   ///< the message is printed
};

/// Prints the message on standard error and, with --json, the object with "crashed" or "not_responding" on standard output; each as a
/// whole and once, also when it is called again.
void reportEarlyEnd(EarlyEndFacts& facts, const EarlyEnd& end) noexcept;
/// kExitController if module code was the cause or may have damaged memory, kExitInterrupted if the run was interrupted without a
/// fault, 128 plus the signal for a crash of a program without modules.
[[nodiscard]] int exitCodeOf(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept;

} // namespace trundle
