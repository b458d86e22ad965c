#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "base/result.h"

namespace trundle {

/// An advisory lock, held for its lifetime, for a read-modify-write of a file. Of two owners, in one process or in two, the
/// second reads what the first has written. Stays valid if the file is replaced. On a file system without locks, locking always
/// succeeds.
class FileLock {
public:
    /// Locks all of these files that exist; links are followed. Locks in a fixed order to avoid deadlocks. Fails if another owner
    /// holds a lock for longer than `atMost`.
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
