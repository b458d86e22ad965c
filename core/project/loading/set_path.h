#pragma once
// Converts overrides of a load (`--set`) into edits of the files that define the values.

#include <map>
#include <vector>

#include "base/text_edit.h"
#include "project/loading/project.h"

namespace trundle {

/// Edits by file that write the load's sets into the text: an existing value is replaced, otherwise an assignment is added to its
/// block. Only valid if the load has no errors in its `--set` texts.
[[nodiscard]] std::map<FileId, std::vector<TextEdit>> editsForSets(const LoadedProject& loaded);

/// The same for sets that are not part of the load, without loading again. Fails if one cannot be parsed or its path leads
/// nowhere; the values are checked only when the edited texts are loaded.
[[nodiscard]] Result<std::map<FileId, std::vector<TextEdit>>> editsForSets(const LoadedProject& loaded,
                                                                           const std::vector<std::string>& sets);

/// Whether one of the load's errors is in a `--set` text.
[[nodiscard]] bool setsFailed(const LoadedProject& loaded);

} // namespace trundle
