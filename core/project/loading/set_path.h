#pragma once
// Converts overrides of a load (`--set`) into edits of the files that define the values.

#include <functional>
#include <map>
#include <string_view>
#include <vector>

#include "base/text_edit.h"
#include "project/loading/project.h"

namespace trundle {

/// Edits by file that write the load's sets into the text: an existing value is replaced, otherwise an assignment is added to its
/// block. Only valid if the load has no errors in its `--set` texts.
[[nodiscard]] std::map<FileId, std::vector<TextEdit>> editsForSets(const LoadedProject& loaded);

/// The same for targets that are not part of the load. `textOf` gives the text of a new value from its range.
[[nodiscard]] std::map<FileId, std::vector<TextEdit>> editsForTargets(
    const LoadedProject& loaded, const std::vector<SetTarget>& sets,
    const std::function<std::string_view(const SourceRange& value)>& textOf);

/// Whether one of the load's errors is in a `--set` text.
[[nodiscard]] bool setsFailed(const LoadedProject& loaded);

} // namespace trundle
