#pragma once
#include <cstdint>
#include <string>

#include "base/result.h"

namespace trundle {

/// The whole content of a regular file. A folder, FIFO, socket or device is refused without blocking; so is a file of more than
/// `mostBytes`. The message contains the path: "cannot read a/b.sim: it is a folder".
[[nodiscard]] Result<std::string> readRegularFile(const std::string& path, std::uint64_t mostBytes = 64u << 20);

/// The attributes of a file that show whether it changed.
struct FileStamp {
    std::uint64_t device = 0, inode = 0, size = 0;
    std::int64_t modifiedNs = 0;
    bool operator==(const FileStamp&) const = default;
};

/// Fails with the same messages for every file type that readRegularFile refuses.
[[nodiscard]] Result<FileStamp> regularFileStamp(const std::string& path);

} // namespace trundle
