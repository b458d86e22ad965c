#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// The right to read a file, change the text and put it back, in this process or another, as long as it lives: of two who do so at once
/// the second sees what the first has written. Survives that the file is replaced by a new one. Where a file system knows no locks,
/// everybody gets one.
class FileLock {
public:
    /// Locks of all these files that exist; links are followed. In one order for everybody, so that no two wait for each other.
    /// Fails where another owner keeps one for longer than `atMost`.
    [[nodiscard]] static Result<std::vector<FileLock>> takeAll(const std::vector<std::string>& paths,
                                                               std::chrono::milliseconds atMost);

    FileLock(FileLock&& other) noexcept;
    FileLock& operator=(FileLock&& other) noexcept;
    ~FileLock();

private:
    explicit FileLock(int file) : m_file(file) {}
    static int openLocked(const std::string& path, std::chrono::steady_clock::time_point until);

    int m_file = -1;
};

} // namespace trundle
