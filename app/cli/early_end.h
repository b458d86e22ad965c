#pragma once
// The words of a program that ends in the middle of a run. Everything here may be called from a signal handler.

#include <atomic>
#include <cstdint>
#include <string>

#include "base/call_monitor.h"

namespace trundle {

enum class EarlyEndKind {
    Crash,         ///< a signal such as SIGSEGV
    Exit,          ///< exit(), quick_exit() or _exit() in code of a module
    NotResponding, ///< asked to end, and a call or a step of the solver went on
    Interrupted,   ///< asked to end twice
};

struct EarlyEnd {
    EarlyEndKind kind = EarlyEndKind::Crash;
    int signal = 0;            ///< of a crash
    bool onRunsThread = true;  ///< false: a thread that code of a module started, or one that the program works with
    const CallTarget* threadOf = nullptr; ///< of a crash in another thread: whose code it runs; nullptr: of no known module
    std::uint32_t waitedS = 0; ///< NotResponding
};

/// Poses of the robots, kept while all is well.
struct EarlyPoses {
    std::string members; ///< of "robots", without braces
    double timeS = 0;    ///< simulated
};

/// What there is to be told, prepared while all was well.
struct EarlyEndFacts {
    const CallMonitor* calls = nullptr;
    const char* activity = "run";  ///< what it interrupts: "run", "description"
    double startS = 0;             ///< of the monotonic clock
    bool simulates = true;         ///< there is a simulated time
    bool terminal = false;         ///< standard error is one: a progress bar may stand in the last line
    std::atomic<bool> json{false}; ///< --json, and its object has not been printed
    /// Entries of "diagnostics" so far, without brackets.
    std::atomic<const std::string*> diagnostics{nullptr};
    /// As they were a second ago at most; nullptr: none yet.
    std::atomic<const EarlyPoses*> poses{nullptr};
    /// Where the ticks are over: the results, printed in place of the few that are known in the middle.
    std::atomic<const std::string*> results{nullptr};
};

/// The sentence on standard error, and with --json the object on standard output, with "crashed" or "not_responding" in it.
void reportEarlyEnd(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept;
/// kExitController where code of a module was at fault, kExitInterrupted where nothing was, 128 and the signal for a crash of our own.
[[nodiscard]] int exitCodeOf(const EarlyEndFacts& facts, const EarlyEnd& end) noexcept;
/// "Segmentation fault".
[[nodiscard]] const char* crashName(int signal) noexcept;

} // namespace trundle
