#pragma once
#include <string>
#include <string_view>

#include "base/result.h"

namespace trundle {

/// Replaces a file's content so that a reader, a crash or a full disk sees either the old bytes or the new ones, never a part.
/// Keeps the file's mode, writes through a symbolic link to its target, creates no folders. Refuses anything that is not a
/// regular file, and a link that leads to nothing: nobody would see where the new file is made. On failure nothing is left behind; what
/// a writer left that was killed in the middle (`.trundle-*.tmp`, more than a minute old and held by nobody) is removed by the next one
/// in the same folder.
[[nodiscard]] Status writeFileAtomically(const std::string& path, std::string_view bytes);

} // namespace trundle
