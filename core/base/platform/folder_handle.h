#pragma once
#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace trundle {

/// A folder that is held open. What is done through it is done in that folder, whatever its path leads to meanwhile, and no symbolic
/// link in it is followed: what is a link is refused, at the moment of use and not before it. Names are of one part, without a slash.
/// An error's message is the reason alone ("it is a symbolic link"); the caller knows the path that people know.
class FolderHandle {
public:
    /// Opens the folder that a path leads to, through links too.
    [[nodiscard]] static Result<FolderHandle> open(const std::string& path);
    /// The same; makes it, and those above it, where they are missing.
    [[nodiscard]] static Result<FolderHandle> make(const std::string& path);

    FolderHandle(FolderHandle&& other) noexcept;
    FolderHandle& operator=(FolderHandle&& other) noexcept;
    ~FolderHandle();

    /// A folder in it.
    [[nodiscard]] Result<FolderHandle> openFolder(const std::string& name) const;
    /// The same; makes it where it is missing.
    [[nodiscard]] Result<FolderHandle> makeFolder(const std::string& name) const;
    /// A new, empty file in place of a regular one, which is removed: a hard link to it elsewhere keeps its content.
    [[nodiscard]] Result<std::FILE*> makeFile(const std::string& name) const;
    /// The content of a regular file.
    [[nodiscard]] Result<std::string> readFile(const std::string& name, std::uint64_t mostBytes) const;
    [[nodiscard]] bool hasFile(const std::string& name) const;    ///< a regular one
    [[nodiscard]] bool hasOwnFile(const std::string& name) const; ///< a regular one of this user, that nobody else may write
    bool removeFile(const std::string& name) const;               ///< a regular one; true where it is gone now
    /// Renames within the folder, in place of what has the new name; of a link, of the link itself.
    [[nodiscard]] Status rename(const std::string& from, const std::string& to) const;

private:
    explicit FolderHandle(int folder) : m_folder(folder) {}
    int m_folder = -1;
};

} // namespace trundle
