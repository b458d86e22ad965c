#pragma once
// Private to base/platform: what those that read files share.

#include <cstdint>
#include <string>

#include <sys/types.h>

#include "base/result.h"

namespace trundle {

/// A file descriptor with an owner.
struct FileDescriptor {
    int file = -1;
    explicit FileDescriptor(int opened) : file(opened) {}
    ~FileDescriptor();
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
};

/// Why nothing of this kind is read or written as a file ("it is a folder"); nullptr for a regular file.
[[nodiscard]] const char* kindRefused(mode_t mode);
/// All bytes of an open file that is a regular one; fails with the reason alone.
[[nodiscard]] Result<std::string> readAll(const FileDescriptor& open, std::uint64_t mostBytes);

} // namespace trundle
