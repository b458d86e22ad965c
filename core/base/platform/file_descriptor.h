#pragma once
// Internal to base/platform: shared by the functions that read files.

#include <cstdint>
#include <string>

#include <sys/types.h>

#include "base/result.h"

namespace trundle {

/// An owned file descriptor.
struct FileDescriptor {
    int file = -1;
    explicit FileDescriptor(int opened) : file(opened) {}
    ~FileDescriptor();
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;
};

/// Why a file of this type is refused ("it is a folder"); nullptr for a regular file.
[[nodiscard]] const char* kindRefused(mode_t mode);
/// All bytes of an open regular file. The error message is the reason without the path.
[[nodiscard]] Result<std::string> readAll(const FileDescriptor& open, std::uint64_t mostBytes);

} // namespace trundle
