#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// Replaces the content of a file atomically: a reader sees either the old bytes or the new ones, also after a crash or on a full
/// disk.
/// Keeps the file mode, writes through a symbolic link to its target, creates no folders. Refuses anything but a regular file,
/// and a dangling link, because the user could not see where the new file is created. A failure leaves no files behind. The
/// temporary files of killed writers in that folder are removed, see removeAbandonedFiles().
[[nodiscard]] Status writeFileAtomically(const std::string& path, std::string_view bytes);
/// A new name for a temporary file: ".trundle-<process>-<number>.tmp".
[[nodiscard]] std::string temporaryName();
/// Keeps an open file with such a name from being removed until it is closed, by a process that inherited it too.
void lockTemporaryFile(int file);
/// Removes files with such names in a folder that are unlocked and over a minute old: those of writers that were killed.
void removeAbandonedFiles(const std::string& folder);
/// Whether this process may write a file or, for a folder, create files in it.
[[nodiscard]] bool isWritable(const std::string& path);

} // namespace trundle
