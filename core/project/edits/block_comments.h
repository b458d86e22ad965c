#pragma once
// The comments around a block that go with it when it is removed, moved or copied. Private to core/project.

#include <cstdint>
#include <optional>
#include <vector>

#include "lang/tree.h"
#include "project/loading/loaded_project.h"

namespace trundle {

/// The start of the line of a block, or of the comments directly above it.
[[nodiscard]] std::uint32_t commentAbove(const Tree& tree, std::uint32_t at);
/// The end of the comments after an offset, or the offset itself; nothing if something else follows on the line.
[[nodiscard]] std::optional<std::uint32_t> endOfLineBehind(const Tree& tree, std::uint32_t offset);
/// An item that begins its line, including a comment after it on its last line.
[[nodiscard]] SourceRange withComment(const LoadedProject& loaded, SourceRange item);
/// The same, including the comments directly above it.
[[nodiscard]] SourceRange withComments(const LoadedProject& loaded, SourceRange item);
/// The same, including the comments directly above it, unless they may be about more: up to the next blank line or comment another item of
/// its kind follows that is not in `chosen`. A comment that begins the file stays there.
[[nodiscard]] SourceRange withOwnComments(const LoadedProject& loaded, SourceRange item, const std::vector<SourceRange>& chosen);

} // namespace trundle
