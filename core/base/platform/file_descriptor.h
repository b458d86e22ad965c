#pragma once
// Internal to base/platform: shared by the functions that read and write files.

#include <cstdint>
#include <string>
#include <string_view>

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
/// Writes all bytes, also after an interruption by a signal. False, with errno, if the system refuses some.
[[nodiscard]] bool writeAll(int file, std::string_view bytes);

} // namespace trundle
