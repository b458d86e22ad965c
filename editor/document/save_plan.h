#pragma once
// What must be written so that a project's opened file means the same from another place. Private to editor/document.

#include <map>
#include <set>
#include <string>

#include "base/result.h"
#include "editor/document/document.h"
#include "parts/parts.h"

namespace trundle {

struct SavePlan {
    std::map<std::string, std::string> moves; ///< files by their path now, and where each is written; the opened one among them
    TextOverlay texts;                        ///< by the new path, imports and names of files written anew where they had to be
    /// Files that are no texts, by their new path, and which each is a copy of. One that is there already is not among them.
    std::map<std::string, std::string> copies;
    Companions companions;
};

/// `mustMove` are files that cannot be saved where they are. Nothing is written: the plan is tried on texts in memory. Fails where
/// a file would take another's place.
[[nodiscard]] Result<SavePlan> planSaveAs(Parts& parts, const Loaded& loaded, OpenOptions options, const std::string& target,
                                          const std::set<std::string>& mustMove, ModuleCopies modules);

} // namespace trundle
