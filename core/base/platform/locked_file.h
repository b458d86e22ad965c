#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// A file that one owner at a time holds, in this process or another. The system lets go of it when its process ends, however it
/// ends. Where a file system knows no locks, everybody gets one.
class LockedFile {
public:
    /// Opens the file, makes it where there is none (not the folders, not through a link), and locks it. Nothing where another
    /// owner holds it; does not wait.
    [[nodiscard]] static Result<std::optional<LockedFile>> take(const std::string& path);
    /// A file of that name must not exist yet.
    [[nodiscard]] static Result<LockedFile> make(const std::string& path);
    /// Whether some owner holds the file now. False where there is no such file.
    [[nodiscard]] static bool isHeld(const std::string& path);

    LockedFile(LockedFile&& other) noexcept;
    LockedFile& operator=(LockedFile&& other) noexcept;
    ~LockedFile() { close(); }

    [[nodiscard]] const std::string& path() const { return m_path; }
    /// Puts bytes at the end. After a failure (a full disk) the end is where it was.
    [[nodiscard]] Status append(std::string_view bytes);
    /// Puts bytes in place of all.
    [[nodiscard]] Status rewrite(std::string_view bytes);
    /// Waits until the disk has it.
    [[nodiscard]] Status sync() const;
    /// The file takes the place of `path`, and is locked there.
    [[nodiscard]] Status renameTo(const std::string& path);
    void close();  ///< lets go; the file stays
    void unlink(); ///< the file is gone, and stays held by who has it
    void remove(); ///< lets go; the file is gone

private:
    LockedFile(int file, std::string path) : m_file(file), m_path(std::move(path)) {}
    [[nodiscard]] Error failure(int why) const;

    int m_file = -1;
    std::string m_path;
};

} // namespace trundle
