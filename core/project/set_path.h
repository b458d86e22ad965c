#pragma once
// The settings of a load (`--set`) as edits of the files that own the values.

#include <map>
#include <vector>

#include "base/text_edit.h"
#include "project/project.h"

namespace trundle {

/// By file, the edits that write the load's sets into the text: only the characters of a value that is there already, else a new
/// assignment in its block. To be used when the load has no errors in its `--set` texts.
[[nodiscard]] std::map<FileId, std::vector<TextEdit>> editsForSets(const Loaded& loaded);

/// The same for sets that the load does not have: nothing is loaded for them. Fails where one cannot be read or leads nowhere;
/// whether the values fit shows in a load of the edited texts.
[[nodiscard]] Result<std::map<FileId, std::vector<TextEdit>>> editsForSets(const Loaded& loaded,
                                                                         const std::vector<std::string>& sets);

/// Whether one of the load's errors stands in a `--set` text.
[[nodiscard]] bool setsFailed(const Loaded& loaded);

} // namespace trundle
