#pragma once
#include <memory>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// Whether a program of that name is in one of the folders of PATH.
[[nodiscard]] bool isInstalled(const std::string& program);

/// A program that is fed through its standard input while it works. It has a process group of its own: Ctrl+C is not for it.
class FedProcess {
public:
    /// The name under which the program finds the open file that it is given.
    static constexpr const char* kGivenFile = "/proc/self/fd/3";
    /// `program` is looked for in PATH. `file`: a descriptor that it gets as kGivenFile; -1: none.
    [[nodiscard]] static Result<std::unique_ptr<FedProcess>> start(const std::string& program,
                                                                   const std::vector<std::string>& arguments, int file = -1);
    /// One that has not finished is told to end, and waited for.
    ~FedProcess();
    FedProcess(const FedProcess&) = delete;
    FedProcess& operator=(const FedProcess&) = delete;

    /// Waits until all is taken. False where it takes no more.
    [[nodiscard]] bool feed(const void* bytes, std::size_t size);
    /// Ends its input and waits for it. True where it says that all went well.
    [[nodiscard]] bool finish();
    /// The last line that it wrote to its standard error; empty where it wrote none.
    [[nodiscard]] std::string lastWords() const;

private:
    FedProcess() = default;

    int m_input = -1, m_words = -1; ///< ours; a file that has what it says
    int m_process = 0;
};

} // namespace trundle
