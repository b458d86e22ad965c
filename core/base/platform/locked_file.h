#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// A file with an exclusive lock, in this process or another. The system releases the lock when the process ends for any reason.
/// On a file system without locks, locking always succeeds.
class LockedFile {
public:
    /// Opens the file, creating it if missing (but no folders, and not through a link), and locks it. Empty if another owner
    /// holds it; does not wait.
    [[nodiscard]] static Result<std::optional<LockedFile>> take(const std::string& path);
    /// Creates and locks a new file; fails if the name exists.
    [[nodiscard]] static Result<LockedFile> make(const std::string& path);
    /// Whether any owner holds the file now. False if the file does not exist.
    [[nodiscard]] static bool isHeld(const std::string& path);

    LockedFile(LockedFile&& other) noexcept;
    LockedFile& operator=(LockedFile&& other) noexcept;
    ~LockedFile() { close(); }

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Appends bytes. After a failure (a full disk) the file has its old size.
    [[nodiscard]] Status append(std::string_view bytes) { return append(std::span(&bytes, 1)); }
    /// Appends all pieces or none.
    [[nodiscard]] Status append(std::span<const std::string_view> pieces);
    /// Replaces the whole content.
    [[nodiscard]] Status rewrite(std::string_view bytes);
    /// Flushes the file to disk (fsync).
    [[nodiscard]] Status sync() const;
    /// Renames the file over `path`, keeping the lock.
    [[nodiscard]] Status renameTo(const std::string& path);
    void close();  ///< releases the lock; the file remains
    void unlink(); ///< removes the name; the lock is kept
    void remove(); ///< removes the file and releases the lock

private:
    LockedFile(int file, std::string path) : m_file(file), m_path(std::move(path)) {}
    [[nodiscard]] Error failure(int why) const;

    int m_file = -1;
    std::string m_path;
};

} // namespace trundle
