#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// Replaces the content of a file atomically: a reader sees either the old bytes or the new ones, also after a crash or on a full
/// disk.
/// Keeps the file mode, writes through a symbolic link to its target, creates no folders. Refuses anything but a regular file,
/// and a dangling link, because the user could not see where the new file is created. A failure leaves no files behind. Temporary
/// files (`.trundle-*.tmp`) of killed writers that are unlocked and over a minute old are removed by the next write in that
/// folder.
[[nodiscard]] Status writeFileAtomically(const std::string& path, std::string_view bytes);
/// Whether this process may write a file or, for a folder, create files in it.
[[nodiscard]] bool isWritable(const std::string& path);

} // namespace trundle
