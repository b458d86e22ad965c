#pragma once
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace trundle {

/// An open folder. Operations act on this folder even if its path leads elsewhere later, and refuse symbolic links in it at the
/// moment of use. Names have one component, without a slash. Error messages are the reason alone ("it is a symbolic link"); the
/// caller adds the path.
class FolderHandle {
public:
    /// Opens the folder at a path, following links.
    [[nodiscard]] static Result<FolderHandle> open(const std::string& path);
    /// The same; creates it and its missing parents.
    [[nodiscard]] static Result<FolderHandle> make(const std::string& path);

    FolderHandle(FolderHandle&& other) noexcept;
    FolderHandle& operator=(FolderHandle&& other) noexcept;
    ~FolderHandle();

    /// Opens a subfolder.
    [[nodiscard]] Result<FolderHandle> openFolder(const std::string& name) const;
    /// The same; creates it if it is missing.
    [[nodiscard]] Result<FolderHandle> makeFolder(const std::string& name) const;
    /// Creates a new, empty file. An existing regular file is unlinked first, so that a hard link to it elsewhere keeps its
    /// content.
    [[nodiscard]] Result<std::FILE*> makeFile(const std::string& name) const;
    /// The content of a regular file.
    [[nodiscard]] Result<std::string> readFile(const std::string& name, std::uint64_t mostBytes) const;
    [[nodiscard]] bool hasFile(const std::string& name) const;    ///< regular files only
    [[nodiscard]] bool hasOwnFile(const std::string& name) const; ///< a regular file of this user that no other user may write
    bool removeFile(const std::string& name) const;               ///< regular files only; true if the file no longer exists
    /// Renames within the folder and replaces an existing file; a link is renamed itself, not its target.
    [[nodiscard]] Status rename(const std::string& from, const std::string& to) const;

    /// Keeps others who call it for the same folder out for the life of this handle. False: another handle keeps it.
    [[nodiscard]] bool lock();

private:
    explicit FolderHandle(int folder) : m_folder(folder) {}
    int m_folder = -1, m_lock = -1;
};

} // namespace trundle
