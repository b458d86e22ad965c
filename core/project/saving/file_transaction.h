#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/result.h"

namespace trundle {

/// Writes, copies and removes several files, all or none: a function that fails leaves no trace of its own file, and rollBack()
/// restores what was changed before it.
class FileTransaction {
public:
    enum class MissingFolder { Fail, Create }; ///< a created folder stays, also after rollBack()

    /// Creates missing folders. Fails if there is a file at the target already.
    [[nodiscard]] Status copy(const std::string& from, const std::string& to);
    /// Replaces or creates a file; see writeFileAtomically().
    [[nodiscard]] Status write(const std::string& path, const std::string& bytes, MissingFolder folder = MissingFolder::Fail);
    /// A file that does not exist counts as removed.
    [[nodiscard]] Status remove(const std::string& path);
    /// Restores in reverse order, so that the older text fits on a full disk as it did before. Returns `why`, extended by every
    /// file that could not be restored.
    [[nodiscard]] Error rollBack(Error why);

private:
    std::vector<std::pair<std::string, std::optional<std::string>>> m_before; // no bytes: the file did not exist
};

} // namespace trundle
