#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "base/platform/limits.h"
#include "base/result.h"

namespace trundle {

/// A child program to run to its end.
struct ProcessRequest {
    std::string program;                   ///< path with a slash; no search
    std::vector<std::string> arguments;    ///< without the program's own name
    std::string input;                     ///< its standard input; empty: /dev/null
    std::string folder;                    ///< its working folder; empty: ours
    double seconds = 10;                   ///< wall clock, then it is killed
    std::uint64_t outputBytes = 64u << 20; ///< more on standard output: it is killed
    std::uint64_t errorBytes = 64u << 10;  ///< more on standard error is dropped
    ResourceLimits limits{.coreDumps = false};
};

enum class ProcessEnd { Exited, Signalled, TimedOut, TooMuchOutput };

struct ProcessResult {
    ProcessEnd end = ProcessEnd::Exited;
    int exitCode = 0;   ///< valid where Exited
    int signal = 0;     ///< valid where Signalled
    std::string output; ///< standard output, cut at outputBytes
    std::string errors; ///< standard error, cut at errorBytes
    double seconds = 0; ///< wall clock it took

    [[nodiscard]] bool succeeded() const { return end == ProcessEnd::Exited && exitCode == 0; }
};

/// Runs a program and waits for it. The child gets a process group of its own, which is killed as a whole where a limit is passed,
/// and dies with us. Fails only where it could not be started. Blocks the calling thread for `seconds` at most.
[[nodiscard]] Result<ProcessResult> runProcess(const ProcessRequest& request);

/// "exited with code 3", "killed by signal 11 (Segmentation fault)", "took longer than 10 s".
[[nodiscard]] std::string describeEnd(const ProcessRequest& request, const ProcessResult& result);

} // namespace trundle
