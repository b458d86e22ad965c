#pragma once
// Allows one window at a time to edit a project. The lock is a locked file, which the system releases when the process ends, even
// after a crash; its content names the holder.

#include <cstdint>
#include <memory>
#include <string>

#include "base/platform/locked_file.h"
#include "base/platform/process_identity.h"

namespace trundle {

struct LockHolder {
    ProcessIdentity process;
    std::string opened;     ///< path of its opened file
    std::int64_t since = 0; ///< s since 1970

    /// For messages: "another window (process 4711 on rover, since 14:05)".
    [[nodiscard]] std::string description() const;
};

class ProjectLock {
public:
    /// Tries to lock a project; if that fails, holder() describes the holder. If the lock file cannot be written, the lock counts
    /// as acquired: without write access this process cannot damage the project either.
    ProjectLock(const std::string& projectFolder, const std::string& opened);
    ~ProjectLock();
    ProjectLock(const ProjectLock&) = delete;
    ProjectLock& operator=(const ProjectLock&) = delete;

    [[nodiscard]] bool taken() const { return m_taken; }
    [[nodiscard]] const LockHolder& holder() const { return m_holder; }

private:
    std::optional<LockedFile> m_file;
    LockHolder m_holder;
    bool m_taken = true;
};

} // namespace trundle
