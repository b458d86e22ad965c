#pragma once
#include <cstdint>
#include <functional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "base/platform/limits.h"
#include "base/result.h"

namespace trundle {

/// A child process to run until it ends.
struct ProcessRequest {
    std::string program;                   ///< path with a slash; no search path
    std::vector<std::string> arguments;    ///< without the program's own name
    std::string input;                     ///< its standard input; empty: /dev/null
    std::string folder;                    ///< its working folder; empty: that of this process
    double seconds = 10;                   ///< wall-clock limit, then it is killed
    std::uint64_t outputBytes = 64u << 20; ///< limit of standard output, then it is killed
    std::uint64_t errorBytes = 64u << 10;  ///< limit of standard error; the rest is dropped
    ResourceLimits limits{.coreDumps = false};
    /// Called in the calling thread with what the process writes to either output, as it comes.
    std::function<void(std::string_view bytes)> received;
    std::stop_token stop; ///< kills it soon after a request, as if its time were over
};

enum class ProcessEnd { Exited, Signalled, TimedOut, TooMuchOutput };

struct ProcessResult {
    ProcessEnd end = ProcessEnd::Exited;
    int exitCode = 0;   ///< valid if Exited
    int signal = 0;     ///< valid if Signalled
    std::string output; ///< standard output, cut at outputBytes
    std::string errors; ///< standard error, cut at errorBytes
    double seconds = 0; ///< wall-clock duration

    [[nodiscard]] bool succeeded() const { return end == ProcessEnd::Exited && exitCode == 0; }
};

/// Runs a program and waits for it. The child has its own process group, which is killed as a whole when a limit is exceeded, and
/// is killed when this process dies. Fails only if the program could not be started. Blocks the calling thread for at most
/// `seconds`.
[[nodiscard]] Result<ProcessResult> runProcess(const ProcessRequest& request);

/// "exited with code 3", "killed by signal 11 (Segmentation fault)", "took longer than 10 s".
[[nodiscard]] std::string describeEnd(const ProcessRequest& request, const ProcessResult& result);

} // namespace trundle
