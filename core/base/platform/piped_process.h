#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// Whether a program with this name is in a folder of PATH.
[[nodiscard]] bool isInstalled(const std::string& program);

/// A child process that receives data on its standard input while it runs. It has its own process group, so Ctrl+C does not reach
/// it.
class PipedProcess {
public:
    /// Path under which the child can open the file passed to it.
    static constexpr const char* kGivenFile = "/proc/self/fd/3";
    /// `program` is searched in PATH. `file`: a descriptor that the child gets as kGivenFile; -1: none.
    [[nodiscard]] static Result<std::unique_ptr<PipedProcess>> start(const std::string& program,
                                                                     const std::vector<std::string>& arguments, int file = -1);
    /// Terminates a child that has not finished, and waits for it.
    ~PipedProcess();
    PipedProcess(const PipedProcess&) = delete;
    PipedProcess& operator=(const PipedProcess&) = delete;

    /// Writes all bytes, blocking. False if the child accepts no more.
    [[nodiscard]] bool feed(const void* bytes, std::size_t size);
    /// Closes its input and waits for it. True if it exited with code 0.
    [[nodiscard]] bool finish();
    /// The last line of its standard error; empty if there is none.
    [[nodiscard]] std::string lastErrorOutput() const;

private:
    PipedProcess() = default;

    int m_input = -1, m_words = -1; ///< our ends: its standard input, and a file with its standard error
    int m_process = 0;
};

} // namespace trundle
