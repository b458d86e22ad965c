#pragma once
// One window at a time edits a project. The lock is a file that the system lets go of when its process ends, so a crash leaves none
// behind; what stands in it tells the others who holds it.

#include <cstdint>
#include <memory>
#include <string>

#include "base/platform/locked_file.h"
#include "base/platform/process_identity.h"

namespace trundle {

struct LockHolder {
    ProcessIdentity process;
    std::string opened;     ///< the file it has open
    std::int64_t since = 0; ///< s since 1970

    /// "another window (process 4711 on rover, since 14:05)".
    [[nodiscard]] std::string said() const;
};

class ProjectLock {
public:
    /// Tries to take a project; holder() says who has it where that failed. Where the lock's file cannot be written there is nothing
    /// to take, and it counts as taken: who cannot write there cannot harm the project either.
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
